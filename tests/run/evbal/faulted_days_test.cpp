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

/// Plays a morning under a random schedule: it ends, the fleet is the same at its end, a replay says the same in every
/// value, and if asked for the digest over DDS is the same. (A run checks vehicles and points itself at every tick.)
/// False if the schedule is refused.
bool play_one(const CommandLine& line, const std::string& scenario, std::uint64_t seed, bool over_dds) {
  const std::string schedule = random_schedule(seed);
  std::ofstream(line.path() / "faults.yaml") << schedule;
  const std::string run = "run " + scenario + " --faults faults.yaml --quiet --engine cuts ";
  const Ended ended = line.evbal(run + "--out day");
  if (ended.status == 2 && ended.err.find("overlaps") != std::string::npos) {
    return false;
  }
  EXPECT_EQ(ended.status, 0) << ended.err << schedule;
  EXPECT_EQ(line.summary("day", "fleet_conserved"), "true") << schedule;
  const Ended replayed = line.evbal("replay day");
  EXPECT_EQ(replayed.status, 0) << replayed.out << replayed.err << schedule;
  if (over_dds) {
    const Ended again = line.evbal(run + "--transport dds --out dds");
    EXPECT_EQ(again.status, 0) << again.err << schedule;
    EXPECT_EQ(line.summary("dds", "digest"), line.summary("day", "digest")) << schedule;
  }
  std::filesystem::remove_all(line.path() / "day");
  std::filesystem::remove_all(line.path() / "dds");
  return true;
}

void play(const CommandLine& line, const std::string& scenario, int days, int dds_every) {
  int played = 0;
  for (std::uint64_t seed = 0; played < days; ++seed) {
    played += play_one(line, scenario, seed, played % dds_every == 0) ? 1 : 0;
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
