#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// The only file of bounds.
fs::path kept(const CommandLine& line) {
  const fs::path bounds = line.path() / "runs/bounds";
  EXPECT_EQ(std::distance(fs::directory_iterator(bounds), {}), 1);
  return fs::directory_iterator(bounds)->path() / "bound.csv";
}

TEST(Bound, IsComputedOnceAndFoundAgain) {
  const CommandLine line;
  const Ended first = line.evbal("bound morning.yaml --prices 2 10");
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_NE(first.out.find("cost at least"), std::string::npos) << first.out;
  EXPECT_NE(first.err.find("1/4  price 2, arrivals rounded down"), std::string::npos) << first.err;
  const std::string csv = text_of(kept(line));
  EXPECT_EQ(csv.rfind("price,bound,tight,down_km,", 0), 0U) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  // Nothing is solved again, whatever controller is asked for, however often plans are made and whether cars may top
  // up.
  line.scenario("morning.yaml", "balancing: {p_shortage: 3}\n");
  const Ended again =
      line.evbal("bound morning.yaml --prices 10 2 --set clock.plan_every=30min --set charging.top_up=true");
  EXPECT_EQ(again.out, first.out);
  EXPECT_EQ(again.err, "");
  EXPECT_EQ(line.evbal("bound morning.yaml --prices 2 --seed 2").status, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(line.path() / "runs/bounds"), {}), 2);
}

TEST(Bound, IsShownByReportsOnItsDay) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("bound morning.yaml --prices 2 10 --quiet").status, 0);
  ASSERT_EQ(line.evbal("run morning.yaml --quiet --out same --set balancing.p_shortage=7").status, 0);
  ASSERT_EQ(line.evbal("run morning.yaml --quiet --out other --seed 2").status, 0);
  EXPECT_NE(text_of(line.path() / "same/report.html").find("\"bound\":{\"km\":"), std::string::npos);
  EXPECT_EQ(text_of(line.path() / "other/report.html").find("\"bound\":{\"km\":"), std::string::npos);
}

TEST(Bound, IsComparedWithASweep) {
  const CommandLine line;
  std::ofstream(line.path() / "calm.yaml") << "schema: 1\ncity: toy-5\nday: 2024-01-11\nseed: 1\ntransport: inproc\n"
                                              "clock: {start: \"07:00\", end: \"10:00\"}\n";
  std::ofstream(line.path() / "sweep.yaml") << "schema: 1\nscenario: calm.yaml\nseeds: [1]\ndays: [2024-01-11]\n"
                                               "variants: [{controller: greedy}, {controller: none}]\n";
  ASSERT_EQ(line.evbal("sweep sweep.yaml --out swept --quiet").status, 0);
  const std::string compare = "compare swept --against bound --at idle_km";
  const std::string drawn = "\"bounds\":[{\"scenario\":\"calm\"";
  ASSERT_EQ(line.evbal("report swept").status, 0);
  EXPECT_EQ(text_of(line.path() / "swept/report.html").find(drawn), std::string::npos);
  const Ended before = line.evbal(compare);
  EXPECT_EQ(before.status, 2);
  EXPECT_NE(before.err.find("compute them with `evbal bound`"), std::string::npos) << before.err;
  ASSERT_EQ(line.evbal("bound calm.yaml --prices 2 10 --quiet").status, 0);
  const Ended compared = line.evbal(compare);
  ASSERT_EQ(compared.status, 0) << compared.err;
  EXPECT_NE(compared.out.find("greedy"), std::string::npos) << compared.out;
  EXPECT_NE(compared.out.find("none"), std::string::npos) << compared.out;
  EXPECT_EQ(line.evbal("compare swept --against bound").status, 2);
  ASSERT_EQ(line.evbal("report swept").status, 0);
  EXPECT_NE(text_of(line.path() / "swept/report.html").find(drawn), std::string::npos);
  std::ofstream(line.path() / "faulted.yaml") << "schema: 1\nscenario: morning.yaml\nseeds: [1]\ndays: [2024-01-11]\n"
                                                 "variants: [{controller: none}]\n";
  ASSERT_EQ(line.evbal("sweep faulted.yaml --out faulted --quiet").status, 0);
  const Ended faulted = line.evbal("compare faulted --against bound --at idle_km");
  EXPECT_EQ(faulted.status, 2);
  EXPECT_NE(faulted.err.find("no bound is kept"), std::string::npos) << faulted.err;
  ASSERT_EQ(line.evbal("bound morning.yaml --prices 2 --quiet").status, 0);
  EXPECT_EQ(line.evbal("compare faulted --against bound --at idle_km").status, 0) << "of the same faults it is known";
}

TEST(Bound, IsTheEndOfTheWayFromOneFrontToAnother) {
  const CommandLine line;
  std::ofstream(line.path() / "calm.yaml") << "schema: 1\ncity: toy-5\nday: 2024-01-11\nseed: 1\ntransport: inproc\n"
                                              "clock: {start: \"07:00\", end: \"10:00\"}\n";
  std::ofstream(line.path() / "sweep.yaml")
      << "schema: 1\nscenario: calm.yaml\nseeds: [1]\ndays: [2024-01-11]\n"
         "variants:\n"
         "  - {controller: ratio, settings: {balancing.p_ratio: [5, 20, 80]}}\n"
         "  - {controller: turnover, settings: {balancing.p_shortage: [5, 20, 80]}}\n";
  ASSERT_EQ(line.evbal("sweep sweep.yaml --out swept --quiet").status, 0);
  const std::string compare = "compare swept --against ratio --fronts";
  const Ended fronts = line.evbal(compare);
  ASSERT_EQ(fronts.status, 0) << fronts.err;
  EXPECT_NE(fronts.out.find("turnover"), std::string::npos) << fronts.out;
  EXPECT_EQ(fronts.out.find("of the way"), std::string::npos) << fronts.out;
  EXPECT_EQ(line.evbal(compare + " --room").status, 2);  // no bound yet
  EXPECT_EQ(line.evbal("compare swept --against ratio --room").status, 2);
  EXPECT_EQ(line.evbal(compare + " --room --metric charger_wait_min").status, 2);
  ASSERT_EQ(line.evbal("bound calm.yaml --prices 2 10 --quiet").status, 0);
  const Ended room = line.evbal(compare + " --room --json");
  ASSERT_EQ(room.status, 0) << room.err;
  EXPECT_NE(room.out.find("\"days\": 1"), std::string::npos) << room.out;
  EXPECT_EQ(room.out.find("\"way\": null"), std::string::npos) << room.out;
}

TEST(Bound, IsOneWhenTimeIsUp) {
  const CommandLine line;
  const Ended ended = line.evbal("bound morning.yaml --prices 2 10 --time-limit 1e-9 --quiet");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_NE(ended.out.find("a bound, not the best: out of time"), std::string::npos) << ended.out;
  EXPECT_NE(text_of(kept(line)).find("\n2,0,no,,,,,"), std::string::npos) << text_of(kept(line));
  // It is not taken for the answer later.
  const Ended again = line.evbal("bound morning.yaml --prices 2 10 --quiet");
  EXPECT_EQ(again.out.find("out of time"), std::string::npos) << again.out;
  // What is known is kept, whatever else is asked for.
  EXPECT_EQ(line.evbal("bound morning.yaml --prices 2 4 --time-limit 1e-9 --quiet").status, 0);
  EXPECT_NE(text_of(kept(line)).find("\n10,"), std::string::npos) << text_of(kept(line));
  EXPECT_EQ(text_of(kept(line)).find("\n2,0,no"), std::string::npos) << text_of(kept(line));
}

TEST(Bound, RefusesWhatIsNoDayOrNoPrice) {
  const CommandLine line;
  EXPECT_EQ(line.evbal("bound nowhere.yaml").status, 2);
  const Ended price = line.evbal("bound morning.yaml --prices 0");
  EXPECT_EQ(price.status, 2);
  EXPECT_NE(price.err.find("give a number above 0"), std::string::npos) << price.err;
  EXPECT_EQ(line.evbal("bound morning.yaml --time-limit -1").status, 2);
  const Ended day = line.evbal("bound morning.yaml --day 2030-01-01");
  EXPECT_EQ(day.status, 2);
  EXPECT_NE(day.err.find("--day"), std::string::npos) << day.err;
  line.scenario("draws.yaml",
                "    - {name: more, type: demand.scale, target: {pick: 1}, start: \"08:00\",\n"
                "       duration: 45min, magnitude: {uniform: {min: 1.1, max: 2.0}}}\n"
                "  runs: 3\n");
  const Ended draws = line.evbal("bound draws.yaml");
  EXPECT_EQ(draws.status, 2);
  EXPECT_NE(draws.err.find("3 draws"), std::string::npos) << draws.err;
}

TEST(Bound, RefusesAFileThatIsNone) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("bound morning.yaml --prices 2 --quiet").status, 0);
  const fs::path file = kept(line);
  std::ofstream(file) << "price,bound\n1,2\n";
  const Ended ended = line.evbal("bound morning.yaml --prices 2 --quiet");
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("bound.csv:1: "), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace evbal
