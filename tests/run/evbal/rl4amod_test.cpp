#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <string>

namespace evbal {
namespace {

const std::string kScript = "python3 " EVBAL_SOURCE_DIR "/examples/rl4amod.py ";

// The page tells this figure.
TEST(Rl4amod, DoingNothingInBrooklynEarnsWhatThePageSays) {
  const CommandLine line;
  const Ended ran = line.evbal("run brooklyn-evening.yaml --controller none --out nothing");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Ended counted =
      line.command(kScript + "profit nothing " EVBAL_SOURCE_DIR "/experiments/cities/brooklyn-14/prices.csv");
  EXPECT_EQ(counted.out, "served 1792, revenue 39860, their trips cost 13494, empty trips cost 0\nprofit 26366\n")
      << counted.err;
  EXPECT_NE(text_of(EVBAL_SOURCE_DIR "/docs/rl4amod.md").find("# 26366\n"), std::string::npos);
}

// Far more passengers than cars, who all go where nobody asks for one: each car serves once.
TEST(Rl4amod, TheOtherSimulatorDoesNothingByItsRules) {
  const CommandLine line;
  std::string demand;
  for (int minute = 480; minute < 500; ++minute) {
    demand += std::string(demand.empty() ? "" : ",") + R"({"time_stamp":)" + std::to_string(minute) +
              R"(,"origin":0,"destination":1,"demand":10,"travel_time":8,"price":10})";
  }
  const auto file = line.path() / "scenario.json";
  std::ofstream(file) << R"({"nlat":2,"nlon":1,"totalAcc":[{"hour":8,"acc":7}],"demand":[)" << demand << "]}";
  const Ended played = line.command(kScript + "nothing scenario.json --ratio 1 --steps 5");
  EXPECT_EQ(played.out, "served 3, revenue 30, their trips cost 12, empty trips cost 0\nprofit 18\n") << played.err;
}

TEST(Rl4amod, AScenarioBecomesAPackThatIsPlayed) {
  const CommandLine line;
  std::string demand;
  std::string empty;
  for (int minute = 0; minute < 240; ++minute) {
    const int from = minute % 3;
    demand += std::string(demand.empty() ? "" : ",") + R"({"time_stamp":)" + std::to_string(20 * 60 + minute) +
              R"(,"origin":)" + std::to_string(from) + R"(,"destination":)" + std::to_string((from + 1) % 3) +
              R"(,"demand":0.5,"travel_time":8,"price":10})";
  }
  for (int pair = 0; pair < 9; ++pair) {
    empty += std::string(empty.empty() ? "" : ",") + R"({"time_stamp":20,"origin":)" + std::to_string(pair / 3) +
             R"(,"destination":)" + std::to_string(pair % 3) + R"(,"reb_time":6})";
  }
  std::ofstream(line.path() / "scenario.json")
      << R"({"nlat":3,"nlon":1,"totalAcc":[{"hour":20,"acc":9},{"hour":21,"acc":9},{"hour":22,"acc":9},)"
      << R"({"hour":23,"acc":9}],"rebTime":[)" << empty << R"(],"demand":[)" << demand << "]}";
  std::ofstream(line.path() / "notes.yaml")
      << "name: small\nsource: nobody\nstep: 30min\n"
         "days: {train: [2024-01-01, 2024-01-02, 2024-01-03], test: [2024-01-04], holidays: []}\n"
         "demand_ratio: 2\nseed: 1\nkmh: 20\n"
         "fleet: {vehicles: 9, battery_kwh: 20, km_per_kwh: 5.5, initial_charge: [0.5, 1], placement: even}\n"
         "charging: {stations: 1, points: 2, power_kw: 50, session_quantiles: [12min, 30min]}\n"
         "passengers: {patience: [1min, 4min]}\n";
  const Ended made = line.evbal("ingest rl4amod scenario.json --notes notes.yaml --out city");
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.out.find("trips a day, mean: 240\n"), std::string::npos) << made.out;
  EXPECT_TRUE(std::filesystem::exists(line.path() / "city" / "prices.csv"));
  const Ended fitted = line.evbal("fit ./city");
  EXPECT_EQ(fitted.status, 0) << fitted.err;
  std::ofstream(line.path() / "day.yaml")
      << "schema: 1\ncity: ./city\nday: 2024-01-04\nseed: 1\ncontroller: robust\ntransport: inproc\n";
  const Ended ran = line.evbal("run day.yaml --out day");
  EXPECT_EQ(ran.status, 0) << ran.err;
}

}  // namespace
}  // namespace evbal
