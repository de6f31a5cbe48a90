#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

int number(const CommandLine& line, const std::string& run, const std::string& metric) {
  return std::stoi(line.summary(run, metric));
}

TEST(TopUp, IsARuleOfTheWorld) {
  const CommandLine line;
  const std::string day = "run morning.yaml --quiet --set charging.top_up=true ";
  ASSERT_EQ(line.evbal("run morning.yaml --quiet --out without").status, 0);
  ASSERT_EQ(line.evbal(day + "--out a").status, 0);
  ASSERT_EQ(line.evbal(day + "--transport dds --out b").status, 0);
  EXPECT_EQ(number(line, "without", "top_ups"), 0);
  EXPECT_GT(number(line, "a", "top_ups"), 0);
  EXPECT_EQ(line.summary("a", "fleet_conserved"), "true");
  EXPECT_EQ(line.summary("a", "digest"), line.summary("b", "digest"));
  EXPECT_NE(line.summary("a", "digest"), line.summary("without", "digest"));
  EXPECT_EQ(line.evbal("replay b --quiet").status, 0);
}

// Before plans knew how far low-battery cars get, they asked for many that did not.
TEST(Plans, AskForCarsThatAreThere) {
  const CommandLine line;
  std::ofstream(line.path() / "none.yaml") << "schema: 1\nfaults: []\n";
  for (const std::string controller : {"nominal", "robust", "turnover", "greedy"}) {
    const std::string day = "run toy.yaml --quiet --transport inproc --faults none.yaml --set charging.top_up=true ";
    ASSERT_EQ(line.evbal(day + "--controller " + controller + " --out " + controller).status, 0);
    const int sent = number(line, controller, "rebalance_moves") + number(line, controller, "charge_moves") +
                     number(line, controller, "top_ups");
    EXPECT_LE(100 * number(line, controller, "refused"), sent) << controller;
  }
}

}  // namespace
}  // namespace evbal
