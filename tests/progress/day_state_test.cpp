#include "experiments/progress/day_state.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

Fate fate(bool served) {
  Fate fate;
  fate.served = served;
  return fate;
}

TickRecord tick_of(int tick, int demand, std::vector<Effect> effects = {}) {
  Departures said;
  said.tick = tick;
  said.region = 1;
  said.demand = demand;
  said.vacant = 10 + tick;
  said.low_battery = 2;
  said.waiting = 3;
  said.fates = {fate(true), fate(false), fate(true)};
  TickRecord record;
  record.tick.tick = tick;
  record.faults.effects = std::move(effects);
  record.exchange.departures = {said};
  return record;
}

TEST(DayWatch, CountsWhatRegionsSay) {
  DayWatch watch(DayClock{}, {});
  watch.add(tick_of(0, 4));
  watch.add(tick_of(1, 5));
  const DayState& day = watch.state();
  EXPECT_EQ(day.ticks, 2);
  EXPECT_EQ(day.served, 4);
  EXPECT_EQ(day.lost, 2);
  EXPECT_EQ(day.demand, (std::vector<long>{0, 9}));
  EXPECT_EQ(day.vacant, (std::vector<long>{0, 11}));
  EXPECT_EQ(day.queue, (std::vector<long>{0, 2}));
  EXPECT_EQ(day.waiting, (std::vector<long>{0, 3}));
}

TEST(DayWatch, DemandIsOfTheLastStepOnly) {
  DayWatch watch(DayClock{}, {});  // six ticks a step
  for (int tick = 0; tick < 8; ++tick) {
    watch.add(tick_of(tick, tick < 2 ? 100 : 1));
  }
  EXPECT_EQ(watch.state().demand, (std::vector<long>{0, 6}));
}

TEST(DayWatch, NamesTheFaultsOfTheTickOnce) {
  DayWatch watch(DayClock{}, {"spike", "outage"});
  watch.add(tick_of(0, 0, {{.fault = 1, .region = 0}, {.fault = 1, .region = 1}}));
  EXPECT_EQ(watch.state().faults, (std::vector<std::string>{"outage"}));
  watch.add(tick_of(1, 0));
  EXPECT_TRUE(watch.state().faults.empty());
}

TEST(DayWatch, KeepsTheLastPlan) {
  DayWatch watch(DayClock{}, {});
  TickRecord planned = tick_of(2, 0);
  planned.exchange.plan.emplace();
  planned.exchange.plan->provenance.controller = "robust";
  watch.add(planned);
  watch.add(tick_of(3, 0));
  EXPECT_EQ(watch.state().planned_at, 10);
  EXPECT_EQ(watch.state().provenance.controller, "robust");
}

}  // namespace
}  // namespace evbal
