#include "tools/evbal/console_table.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(ConsoleTable, SaysThatARecoveryWasNotSeen) {
  const std::string table = cost_table({{"lost", {.with = 3.0, .without = 1.0}}, {"served", {.recovered = 30}}});
  EXPECT_NE(table.find("not seen before the day ended\n"), std::string::npos) << table;
  EXPECT_NE(table.find("30 min\n"), std::string::npos) << table;
  EXPECT_EQ(table.find("never"), std::string::npos) << table;
}

TEST(ConsoleTable, ShowsACrossCheckOnlyWhereOneWasMade) {
  const auto run = [](const std::string& controller, const std::optional<CrossChecked>& check) {
    RunResult result;
    result.controller = controller;
    result.cross_check = check;
    return result;
  };
  const RunResult unchecked = run("greedy", std::nullopt);
  EXPECT_EQ(side_by_side({unchecked}).find("ipopt"), std::string::npos);
  const RunResult checked = run("robust", CrossChecked{"ipopt", 1, 0, 3e-10});
  const RunResult failed = run("ratio", CrossChecked{"ipopt", 0, 1, 0.0});
  const std::string table = side_by_side({unchecked, checked, failed});
  EXPECT_NE(table.find("relative difference to ipopt                  -       3e-10    unsolved\n"), std::string::npos)
      << table;
}

}  // namespace
}  // namespace evbal
