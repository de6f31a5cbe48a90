#include "faults/schedule/by_hand.hpp"

#include "tests/faults/schedule_fixture.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

using testing::outage;
using testing::read_text;
using testing::schedule_of;
using testing::small_context;

constexpr int half_past_seven = 30;  // tick

Schedule with(const std::string& entry, int tick = half_past_seven, const std::string& head = "",
              const std::vector<std::string>& faults = {}) {
  return with_fault_by_hand(read_text(schedule_of(faults, head)), YamlValue::parse_option(entry, "inject"),
                            small_context(), tick);
}

/// What a fault by hand is refused with.
std::string refusal(const std::string& entry, int tick = half_past_seven, const std::string& head = "",
                    const std::vector<std::string>& faults = {}) {
  try {
    with(entry, tick, head, faults);
    return "taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    return error.what();
  }
}

const std::string closed = "{type: charger.outage, target: {regions: [3]}, duration: 30min, magnitude: {points: 5}}";

TEST(FaultByHand, IsTheFaultThatAScheduleWouldHaveHad) {
  const Schedule by_hand = with(closed, half_past_seven, "", {outage});
  const Schedule asked =
      read_text(schedule_of({outage, "{name: by-hand-1, start: \"07:30\", " + closed.substr(1, closed.size() - 2)}));
  EXPECT_EQ(by_hand, asked);
}

TEST(FaultByHand, BeginsAtItsTickAndNotBefore) {
  for (const int tick : {0, 1, 100, DayClock{}.ticks() - 1}) {
    const Schedule schedule = with(closed, tick);
    EXPECT_TRUE(tick == 0 || faults_at(schedule, DayClock{}, tick - 1).effects.empty()) << tick;
    EXPECT_EQ(faults_at(schedule, DayClock{}, tick).effects.size(), 1U) << tick;
  }
}

TEST(FaultByHand, GetsANameOfItsOwn) {
  const std::string taken =
      "{name: by-hand-1, type: travel.slow, target: {regions: [0]}, start: \"09:00\", duration: 1h, magnitude: 2";
  EXPECT_EQ(with(closed, half_past_seven, "", {taken}).faults.back().name, "by-hand-2");
  EXPECT_EQ(with("{name: mine, " + closed.substr(1)).faults.back().name, "mine");
}

TEST(FaultByHand, IsRefusedAsInASchedule) {
  EXPECT_EQ(refusal("{type: charger.outage, target: {regions: [0]}, duration: 30min, magnitude: {points: 1}}"),
            "inject: region 0 has no charging points; those with points are 1, 3, 4");
  EXPECT_EQ(refusal("{type: travel.slow, target: {regions: [0]}, duration: 30min, magnitude: 11}"),
            "inject: `11` is out of range; give a value from 1 to 10");
  EXPECT_EQ(
      refusal("{type: travel.slow, target: {regions: [0]}, duration: 30min, magnitude: 2, much: 3}").substr(0, 26),
      "inject: unknown key `much`");
}

TEST(FaultByHand, KeepsTheGuard) {
  const std::string again = "{type: charger.outage, target: {regions: [1]}, duration: 30min, magnitude: {points: 1}}";
  EXPECT_EQ(refusal(again, half_past_seven, "", {outage}),
            "inject: fault `by-hand-1` overlaps `outage`: both are charger.outage in region 1 from 07:30 to 08:00; "
            "move one in time or to other regions");
  EXPECT_EQ(refusal(closed, half_past_seven, "guard: {max_active: 1}, ", {outage}),
            "inject: with fault `by-hand-1` 2 faults are active at 07:30; the guard's max_active allows 1");
  EXPECT_EQ(refusal(closed, half_past_seven, "guard: {min_working_points: 32}, ", {outage}),
            "inject: fault `by-hand-1` leaves 29 charging points working at 07:30; the guard's min_working_points asks "
            "for 32");
  EXPECT_EQ(refusal("{name: outage, " + closed.substr(1), half_past_seven, "", {outage}),
            "inject: fault `outage` has the name of `outage`; give each a name of its own");
}

TEST(FaultByHand, HasNoTimeOfItsOwn) {
  EXPECT_EQ(refusal("{start: \"09:00\", " + closed.substr(1)),
            "inject: a fault by hand begins at the next tick; leave `start` out");
  EXPECT_EQ(refusal("{arrivals: {poisson: {per_hour: 1}}, " + closed.substr(1)),
            "inject: a fault by hand begins at the next tick; leave `arrivals` out");
}

TEST(FaultByHand, WaitsForTheInjector) {
  const std::string away =
      "{name: gone, type: process.kill, target: {injector: true}, start: \"07:00\", restart_after: 40min";
  EXPECT_EQ(refusal(closed, half_past_seven, "", {away}),
            "inject: the injector is away or late until 07:40, by fault `gone`; no other fault can begin before");
  EXPECT_EQ(refusal(closed, 32, "", {away}), "taken");
}

}  // namespace
}  // namespace evbal
