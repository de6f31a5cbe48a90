#include "faults/schedule/fault_types.hpp"
#include "tests/run/evbal/command_line.hpp"
#include "tests/run/evbal/random_schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

/// What is played: a few mornings, or what the long tests ask for: whole days, each of them over DDS too.
struct Plan {
  int days = 0;
  int dds_every = 1;
  std::string clock;
  Extent faults;
};

Plan planned(int mornings, int dds_every, int long_share) {
  const char* many = std::getenv("EVBAL_FAULTED_DAYS");
  if (many != nullptr) {
    return {std::stoi(many) / long_share, 1, "start: \"05:00\", end: \"24:00\"", {"05:00", "23:30", 12}};
  }
  return {mornings, dds_every, "start: \"07:00\", end: \"10:00\"", {"07:00", "09:30", 6}};
}

/// Plays a day under a random schedule: it ends, the fleet is the same at its end, a replay says the same in every
/// value, and if asked for the digest over DDS is the same. (A run checks vehicles and points itself at every tick.)
/// False if the schedule is refused.
bool play_one(const CommandLine& line, const std::string& schedule, bool over_dds) {
  std::ofstream(line.path() / "faults.yaml") << schedule;
  const std::string run = "run day.yaml --faults faults.yaml --quiet --engine cuts ";
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

void play(const std::string& city_and_controller, const Plan& plan) {
  const CommandLine line;
  std::ofstream(line.path() / "day.yaml")
      << "schema: 1\nseed: 1\ntransport: inproc\n"
      << city_and_controller << "clock: {" << plan.clock << ", tick: 5min, step: 30min, plan_every: 10min}\n";
  int played = 0;
  for (std::uint64_t seed = 0; played < plan.days; ++seed) {
    played += play_one(line, random_schedule(seed, plan.faults), played % plan.dds_every == 0) ? 1 : 0;
  }
}

TEST(FaultedDays, DrawFromEveryType) {
  for (const auto& name : fault_type_names()) {
    EXPECT_EQ(std::ranges::count(fault_fields(), name, [](const auto& row) { return std::string(row.first); }), 1)
        << name;
  }
}

TEST(FaultedDays, EndAndAreTheSameAgainOnToy) {
  play("city: toy-5\nday: 2024-01-11\ncontroller: nominal\n", planned(8, 4, 1));
}

TEST(FaultedDays, EndAndAreTheSameAgainInSanFrancisco) {
  play("city: san-francisco-54\nday: 2008-06-03\ncontroller: robust\n", planned(0, 5, 10));
}

}  // namespace
}  // namespace evbal
