#include "faults/schedule/fault_types.hpp"
#include "tests/run/evbal/command_line.hpp"
#include "tests/run/evbal/random_schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

/// Days to play: a few, or as many as the long tests ask for.
int days_asked(int few) {
  const char* many = std::getenv("EVBAL_FAULTED_DAYS");
  return many == nullptr ? few : std::stoi(many);
}

/// Plays mornings under random schedules: each ends, the fleet is the same at its end, a replay says the same in every
/// value, and every `dds_every`-th has the same digest over DDS. (A run checks vehicles and points itself at every
/// tick.)
void play(const CommandLine& line, const std::string& scenario, int days, int dds_every) {
  std::uint64_t seed = 0;
  for (int day = 0; day < days; ++seed) {
    const std::string name = std::to_string(seed);
    const std::string faults = " --faults f" + name + ".yaml --quiet --engine cuts --out ";
    std::ofstream(line.path() / ("f" + name + ".yaml")) << random_schedule(seed);
    const Ended ended = line.evbal("run " + scenario + faults + "day" + name);
    if (ended.status == 2 && ended.err.find("overlaps") != std::string::npos) {
      continue;
    }
    ASSERT_EQ(ended.status, 0) << ended.err << random_schedule(seed);
    EXPECT_EQ(line.summary("day" + name, "fleet_conserved"), "true") << random_schedule(seed);
    const Ended replayed = line.evbal("replay day" + name);
    EXPECT_EQ(replayed.status, 0) << replayed.out << replayed.err << random_schedule(seed);
    if (++day % dds_every == 0) {
      const Ended over_dds = line.evbal("run " + scenario + faults + "dds" + name + " --transport dds");
      ASSERT_EQ(over_dds.status, 0) << over_dds.err << random_schedule(seed);
      EXPECT_EQ(line.summary("dds" + name, "digest"), line.summary("day" + name, "digest")) << random_schedule(seed);
    }
    std::filesystem::remove_all(line.path() / ("day" + name));
    std::filesystem::remove_all(line.path() / ("dds" + name));
  }
}

TEST(FaultedDays, DrawFromEveryType) {
  for (const auto& name : fault_type_names()) {
    EXPECT_EQ(std::ranges::count(fault_fields(), name, [](const auto& row) { return std::string(row.first); }), 1)
        << name;
  }
}

TEST(FaultedDays, EndAndAreTheSameAgainOnToy) {
  const CommandLine line;
  play(line, "morning.yaml", days_asked(8), 4);
}

TEST(FaultedDays, EndAndAreTheSameAgainInSanFrancisco) {
  const int days = days_asked(0) / 10;
  const CommandLine line;
  std::ofstream(line.path() / "sf.yaml")
      << "schema: 1\ncity: san-francisco-54\nday: 2008-06-03\nseed: 1\ncontrollers: [robust]\ntransport: inproc\n"
         "clock: {start: \"07:00\", end: \"10:00\", tick: 5min, step: 30min, plan_every: 10min}\n";
  play(line, "sf.yaml", days, 5);
}

}  // namespace
}  // namespace evbal
