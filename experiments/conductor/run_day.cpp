#include "experiments/conductor/run_day.hpp"

#include "agents/region/draws.hpp"
#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "experiments/conductor/roads.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace evbal {
namespace {

/// Throws unless `holds`.
void require(bool holds, const World& world, int tick, int region, const std::string& what) {
  if (!holds) {
    throw run_failed("tick " + std::to_string(tick) + " (" + time_of_day(world.clock, world.clock.minute_of(tick)) +
                     "), region " + std::to_string(region) + " (" + world.city.regions[region].name + "): " + what);
  }
}

/// Every region that is due has spoken, of this tick and in its turn.
void check_complete(const Tick& tick, const Exchange& exchange) {
  const auto in_turn = [&](const auto& messages) {
    return std::equal(
        messages.begin(), messages.end(), tick.due.begin(), tick.due.end(),
        [&](const auto& message, int region) { return message.tick == tick.tick && message.region == region; });
  };
  if (!in_turn(exchange.departures) || (tick.plan_due && !in_turn(exchange.reports)) ||
      tick.plan_due != exchange.plan.has_value() || (exchange.plan && exchange.plan->tick != tick.tick)) {
    throw run_failed("tick " + std::to_string(tick.tick) + ": reports, plan or departures are missing");
  }
}

/// With as many vehicles in every region as it was handed, plants + roads = fleet: each vehicle has one holder.
void check_vehicles_and_points(const World& world, const Roads& roads, const Departures& said) {
  const int here = said.vacant + said.low_battery + said.plugged + said.broken;
  const int handed = roads.held_by(said.region);
  require(here == handed, world, said.tick, said.region,
          "has " + std::to_string(here) + " vehicles, was handed " + std::to_string(handed));
  require(said.plugged <= said.points, world, said.tick, said.region,
          std::to_string(said.plugged) + " points in use, " + std::to_string(said.points) + " work");
}

void check_plan(const World& world, const Plan& plan, const std::vector<Report>& reports) {
  std::map<int, int> vacant;
  std::map<int, int> low_battery;
  for (const auto& move : plan.moves) {
    (move.errand == Errand::rebalance ? vacant : low_battery)[move.from] += move.count;
  }
  std::set<int> estimated;
  for (const auto& rejection : plan.provenance.rejected) {
    estimated.insert(rejection.region);
  }
  for (const auto& report : reports) {
    if (estimated.contains(report.region)) {
      continue;
    }
    require(vacant[report.region] <= report.vacant && low_battery[report.region] <= report.low_battery, world,
            plan.tick, report.region, "is planned to send more vehicles than it reported");
  }
}

Tick announce(const World& world, int tick, Roads& roads, const Faults& faults) {
  Tick announced;
  announced.tick = tick;
  announced.plan_due = world.clock.plan_due(tick);
  announced.due.resize(world.city.regions.size());
  std::iota(announced.due.begin(), announced.due.end(), 0);
  announced.arrivals = roads.hand_out(world.clock.minute_of(tick + 1));
  announced.under_way = roads.under_way();
  announced.effects = faults.effects;
  return announced;
}

}  // namespace

void run_day(const World& world, Players& players, const std::function<void(const TickRecord&)>& observe) {
  Roads roads(draw_fleet(world));
  for (int tick = 0; tick < world.clock.ticks(); ++tick) {
    check_interrupt();
    TickRecord record;
    record.faults = players.faults(tick);
    record.tick = announce(world, tick, roads, record.faults);
    record.exchange = players.play(record.tick);
    check_complete(record.tick, record.exchange);
    for (const auto& departures : record.exchange.departures) {
      roads.take(departures, world.clock.minute_of(tick + 1));
    }
    for (const auto& departures : record.exchange.departures) {
      check_vehicles_and_points(world, roads, departures);
    }
    if (record.exchange.plan) {
      check_plan(world, *record.exchange.plan, record.exchange.reports);
    }
    observe(record);
  }
}

}  // namespace evbal
