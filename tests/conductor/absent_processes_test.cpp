// Days in which a schedule takes processes and samples away, played in this process.

#include "agents/protocol/fingerprint.hpp"
#include "experiments/conductor/attendance.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/conductor/run_day.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

namespace evbal {
namespace {

struct Window {
  int first = 0;
  int last = 0;
};

/// The effect in each tick of the window, as an injector says it.
void put(std::vector<Faults>& faults, Effect effect, const Window& window) {
  const bool absence = effect.type == EffectType::process_kill || effect.type == EffectType::process_pause;
  for (int tick = window.first; tick < std::min(window.last, static_cast<int>(faults.size())); ++tick) {
    effect.magnitude = absence ? window.last - tick : effect.magnitude;
    faults[tick].effects.push_back(effect);
  }
}

std::vector<Faults> quiet(const World& world) {
  std::vector<Faults> faults(world.clock.ticks());
  for (int tick = 0; tick < world.clock.ticks(); ++tick) {
    faults[tick].tick = tick;
  }
  return faults;
}

Effect effect_on(EffectType type, int region, ProcessRole process = ProcessRole::agent, double magnitude = 0.0) {
  Effect effect;
  effect.type = type;
  effect.region = region;
  effect.process = process;
  effect.magnitude = magnitude;
  return effect;
}

std::vector<TickRecord> play(const World& world, const std::vector<Faults>& faults, int regions_per_process = 1) {
  InprocPlayers players(
      world, [](const Tick& tick, const auto& reports) { return test::wander(7, tick.tick, reports); },
      [&](int tick) { return faults[tick]; }, regions_per_process);
  std::vector<TickRecord> day;
  run_day(world, players, [&](const TickRecord& record) { day.push_back(record); });
  return day;
}

std::string digest_of(const std::vector<TickRecord>& day) {
  Digest digest;
  for (const auto& record : day) {
    fingerprint(digest, record.faults);
    for (const auto& report : record.exchange.reports) {
      fingerprint(digest, report);
    }
    for (const auto& said : record.exchange.departures) {
      fingerprint(digest, said);
    }
  }
  return digest.hex();
}

/// Up to five absences, delays and losses.
rc::Gen<std::vector<Faults>> outages_for(const World& world) {
  return rc::gen::exec([world] {
    std::vector<Faults> faults = *test::faults_for(world);
    const int count = *rc::gen::inRange(0, 6);
    for (int i = 0; i < count; ++i) {
      const auto type = *rc::gen::element(EffectType::process_kill, EffectType::process_pause, EffectType::process_slow,
                                          EffectType::network_drop, EffectType::network_partition);
      const bool of_process = family_of(type) == FaultFamily::process;
      const auto process = of_process
                               ? *rc::gen::element(ProcessRole::agent, ProcessRole::coordinator, ProcessRole::injector)
                               : ProcessRole::agent;
      const int region = process == ProcessRole::agent ? *rc::gen::inRange(0, world.city.size()) : no_region;
      Effect effect = effect_on(type, region, process, type == EffectType::network_drop ? 0.5 : 4.0);
      effect.fault = 10 + i;
      const int first = *rc::gen::inRange(0, world.clock.ticks());
      put(faults, effect, {first, first + *rc::gen::inRange(1, world.clock.ticks() + 1)});
    }
    return faults;
  });
}

// run_day checks the fleet and the points of every tick, of those that are told late too.
RC_GTEST_PROP(AbsentProcesses, EveryDayEndsWhole, ()) {
  const World world = *test::small_worlds();
  const auto faults = *outages_for(world);
  const int together = *rc::gen::inRange(1, 4);
  const auto day = play(world, faults, together);
  RC_ASSERT(static_cast<int>(day.size()) == world.clock.ticks());
  for (int tick = 0; tick < world.clock.ticks(); ++tick) {
    RC_ASSERT(day[tick].tick.tick == tick);
    const auto& all = day[tick].exchange.departures;
    RC_ASSERT(static_cast<int>(all.size()) == world.city.size());
    for (int region = 0; region < world.city.size(); ++region) {
      RC_ASSERT(all[region].region == region && all[region].tick == tick);
    }
  }
  RC_ASSERT(digest_of(day) == digest_of(play(world, faults, together)));
}

World busy_morning() {
  SyntheticOptions options;
  options.regions = 4;
  options.trips_per_day = 3000.0;
  options.vehicles = 80;
  options.stations = 2;
  options.points = 8;
  World world = test::world_of(options, {.start = 7 * 60, .end = 10 * 60});
  world.city.passengers = {.patience_low = 5.0, .patience_high = 12.0};
  return world;
}

const Departures& said_of(const std::vector<TickRecord>& day, int tick, int region) {
  return day[tick].exchange.departures[region];
}

TEST(AbsentProcesses, ARegionWithoutItsAgentDispatchesNobody) {
  const World world = busy_morning();
  for (const EffectType type : {EffectType::process_kill, EffectType::process_pause}) {
    auto faults = quiet(world);
    put(faults, effect_on(type, 2), {6, 14});
    const auto day = play(world, faults);
    int lost = 0;
    int demand = 0;
    for (int tick = 6; tick < 14; ++tick) {
      EXPECT_EQ(day[tick].tick.due, (std::vector<std::int32_t>{0, 1, 3}));
      const Departures& said = said_of(day, tick, 2);
      EXPECT_TRUE(said.departures.empty());
      demand += said.demand;
      for (const Fate& fate : said.fates) {
        EXPECT_FALSE(fate.served);
        ++lost;
      }
      for (const auto& arrival : day[tick].tick.arrivals) {
        EXPECT_NE(arrival.region, 2) << "cars wait on the road";
      }
      ASSERT_EQ(day[tick].seen.size(), 1U);
      EXPECT_EQ(day[tick].seen[0].observed.amount, 1.0);
    }
    EXPECT_GT(demand, 20) << "the passengers do not know";
    EXPECT_GT(lost, 10);
    EXPECT_FALSE(said_of(day, 15, 2).departures.empty()) << "back again";
    const auto& after = day[14].tick.arrivals;
    EXPECT_TRUE(std::any_of(after.begin(), after.end(), [](const auto& car) { return car.region == 2; }));
    EXPECT_TRUE(day[14].seen.empty());
  }
}

TEST(AbsentProcesses, WhoNeverComesBackIsHeardAtTheDaysEnd) {
  const World world = busy_morning();
  auto faults = quiet(world);
  put(faults, effect_on(EffectType::process_kill, 1), {10, 1000});
  const auto day = play(world, faults);
  ASSERT_EQ(static_cast<int>(day.size()), world.clock.ticks());
  EXPECT_GT(said_of(day, world.clock.ticks() - 1, 1).demand, 0);
}

TEST(AbsentProcesses, WhoIsAwayAgainSaysNothingTwice) {
  const World world = busy_morning();
  auto faults = quiet(world);
  put(faults, effect_on(EffectType::process_kill, 1), {4, 20});
  put(faults, effect_on(EffectType::process_kill, 2), {6, 8});
  put(faults, effect_on(EffectType::process_pause, 2), {10, 12});
  const auto day = play(world, faults);
  ASSERT_EQ(static_cast<int>(day.size()), world.clock.ticks());
  for (const auto& record : day) {
    const auto& said = record.exchange.departures;
    ASSERT_EQ(said.size(), 4U) << record.tick.tick;
    for (int region = 0; region < 4; ++region) {
      EXPECT_EQ(said[static_cast<std::size_t>(region)].region, region) << record.tick.tick;
    }
  }
}

TEST(AbsentProcesses, WithoutCoordinatorNobodyReportsAndEveryoneFollowsHisRule) {
  const World world = busy_morning();
  auto faults = quiet(world);
  put(faults, effect_on(EffectType::process_kill, no_region, ProcessRole::coordinator), {6, 12});
  const auto day = play(world, faults);
  for (int tick = 6; tick < 12; ++tick) {
    EXPECT_FALSE(day[tick].exchange.plan);
    EXPECT_TRUE(day[tick].exchange.reports.empty());
    EXPECT_EQ(day[tick].tick.unplanned.size(), world.clock.plan_due(tick) ? 4U : 0U);
  }
  int demand = 0;
  for (int tick = 4; tick < 12; ++tick) {  // the report of tick 4 has what appeared before it
    demand += said_of(day, tick, 0).demand;
  }
  EXPECT_EQ(day[12].exchange.reports.at(0).demand, demand) << "the first report after counts since the last";
}

TEST(AbsentProcesses, LostSamplesReachNobody) {
  const World world = busy_morning();
  auto faults = quiet(world);
  put(faults, effect_on(EffectType::network_partition, 2), {6, 12});
  std::vector<std::size_t> heard;
  InprocPlayers players(
      world,
      [&](const Tick& tick, const auto& reports) {
        heard.push_back(reports.size());
        Plan plan = test::hold(tick.tick);
        if (reports.size() < 4 || reports[2].vacant > 0) {
          plan.moves.push_back({.from = 2, .to = 0, .count = 1, .errand = Errand::rebalance});
        }
        return plan;
      },
      [&](int tick) { return faults[tick]; });
  std::vector<TickRecord> day;
  run_day(world, players, [&](const TickRecord& record) { day.push_back(record); });
  EXPECT_EQ(heard, (std::vector<std::size_t>{4, 4, 4, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4}));
  for (int tick = 0; tick < world.clock.ticks(); tick += 2) {
    int followed = said_of(day, tick, 2).refused;
    for (const auto& car : said_of(day, tick, 2).departures) {
      followed += car.errand == Errand::rebalance ? 1 : 0;
    }
    EXPECT_EQ(followed, tick >= 6 && tick < 12 ? 0 : static_cast<int>(day[tick].exchange.plan->moves.size())) << tick;
    EXPECT_EQ(day[tick].exchange.reports.size(), 4U) << "made, and recorded";
  }
}

TEST(AbsentProcesses, WhileTheInjectorIsAwayWhatItSaidLastGoesOn) {
  const World world = busy_morning();
  for (const EffectType type : {EffectType::process_kill, EffectType::process_pause, EffectType::process_slow}) {
    auto faults = quiet(world);
    Effect outage = effect_on(EffectType::charger_outage, 0, ProcessRole::agent, 2.0);
    put(faults, outage, {4, 7});
    Effect missed = effect_on(EffectType::demand_scale, 1, ProcessRole::agent, 3.0);
    missed.fault = 1;
    put(faults, missed, {8, 10});
    Effect injector = effect_on(type, no_region, ProcessRole::injector, 9.0);
    injector.fault = 2;
    put(faults, injector, {6, 12});
    const auto day = play(world, faults);
    const auto active = [&](int tick, int fault) {
      const auto& effects = day[tick].faults.effects;
      return std::any_of(effects.begin(), effects.end(), [&](const Effect& effect) { return effect.fault == fault; });
    };
    for (int tick = 0; tick < world.clock.ticks(); ++tick) {
      EXPECT_EQ(active(tick, 0), tick >= 4 && tick < 12) << tick << ": nobody ends it";
      EXPECT_FALSE(active(tick, 1)) << "was due while nobody said so";
      EXPECT_EQ(active(tick, 2), tick >= 6 && tick < 12) << tick;
    }
  }
}

}  // namespace
}  // namespace evbal
