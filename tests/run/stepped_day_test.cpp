#include "experiments/run/stepped_day.hpp"

#include "common/error.hpp"
#include "common/random.hpp"
#include "experiments/run/record_day.hpp"
#include "experiments/run/stepped_controller.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace evbal {
namespace {

Scenario toy(const std::string& faults = "") {
  Overrides overrides;
  if (!faults.empty()) {
    overrides.faults = test::in_source("experiments/faults/" + faults);
  }
  return read_scenario(test::in_source("experiments/scenarios/toy.yaml"), overrides);
}

DayResult stepped_by(const Scenario& scenario, const std::string& controller) {
  SteppedDay day(scenario);
  SteppedController planner(day, controller);
  while (!day.over()) {
    day.step(planner.plan());
  }
  return day.result();
}

/// Cars to anywhere, more than there are.
std::vector<Move> any_moves(const World& world, int tick) {
  RandomStream random(5, Purpose::bootstrap, {.tick = static_cast<std::uint64_t>(tick)});
  std::vector<Move> moves;
  for (const Errand errand : {Errand::rebalance, Errand::charge}) {
    for (int from = 0; from < world.city.size(); ++from) {
      for (int to = 0; to < world.city.size(); ++to) {
        if (from != to && random.uniform() < 0.5) {
          moves.push_back({from, to, 1 + static_cast<int>(random.uniform(0.0, 30.0)), errand});
        }
      }
    }
  }
  return moves;
}

void step_anywhere(SteppedDay& day) {
  day.step(plan_within_reports(day, any_moves(day.scenario().world, day.tick().tick), "own"));
}

std::vector<Move> moves_then(SteppedController& controller) {
  return controller.plan().moves;
}

bool same(const std::vector<Move>& a, const std::vector<Move>& b) {
  return std::ranges::equal(a, b, [](const Move& x, const Move& y) {
    return x.from == y.from && x.to == y.to && x.count == y.count && x.errand == y.errand;
  });
}

TEST(SteppedDay, IsTheDayThatIsPlayedInOneGo) {
  for (const char* faults : {"", "crashing-agents.yaml", "coordinator-lost.yaml", "lossy-reports.yaml"}) {
    const Scenario scenario = toy(faults);
    const DayResult played = play_day(with_controller(scenario, "greedy"));
    const DayResult stepped = stepped_by(scenario, "greedy");
    EXPECT_EQ(stepped.digest, played.digest) << faults;
    EXPECT_EQ(stepped.fallbacks, played.fallbacks) << faults;
  }
}

TEST(SteppedDay, OfAControllerThatForeseesIsTheSameToo) {
  const Scenario scenario = toy();
  EXPECT_EQ(stepped_by(scenario, "oracle").digest, play_day(with_controller(scenario, "oracle")).digest);
}

TEST(SteppedDay, LeavesOutCarsThatAreNotReported) {
  for (const char* faults : {"", "lying-sensors.yaml", "crashing-agents.yaml", "split-city.yaml"}) {
    SteppedDay day(toy(faults));
    while (!day.over()) {
      step_anywhere(day);  // the conductor refuses a plan of more cars than are reported
    }
    EXPECT_GT(day.result().metrics.totals.flows.rebalance_moves, 100) << faults;
  }
}

TEST(SteppedController, HearsOfWhatOthersPlannedWhileItWasNotAsked) {
  SteppedDay day(toy("lying-sensors.yaml"));
  SteppedController always(day, "greedy");
  for (int plan = 0; plan < 60; ++plan) {
    always.plan();
    step_anywhere(day);
  }
  SteppedController late(day, "greedy");
  EXPECT_TRUE(same(moves_then(always), moves_then(late)));
}

TEST(SteppedController, PlansOnceForATick) {
  SteppedDay day(toy());
  SteppedController controller(day, "robust");
  const auto moves = moves_then(controller);
  EXPECT_TRUE(same(moves, moves_then(controller)));
}

TEST(SteppedController, IsOneThatThereIs) {
  const SteppedDay day(toy());
  EXPECT_THROW(SteppedController(day, "grdy"), Error);
}

}  // namespace
}  // namespace evbal
