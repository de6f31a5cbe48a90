#include "experiments/conductor/run_day.hpp"

#include "agents/region/draws.hpp"
#include "experiments/conductor/roads.hpp"

#include <numeric>
#include <vector>

namespace evbal {
namespace {

class Checks {
 public:
  Checks(const World& world, const Roads& roads) : world_(world), roads_(roads) {}

  void check(const TickRecord& record) const {
    check_departures(record);
    if (record.exchange.plan) {
      check_plan(*record.exchange.plan, record.exchange.reports);
    }
  }

 private:
  void require(bool holds, int tick, int region, const std::string& what) const {
    if (!holds) {
      throw run_failed("tick " + std::to_string(tick) + " (" + time_of_day(world_.clock, world_.clock.minute_of(tick)) +
                       "), region " + std::to_string(region) + " (" + world_.city.regions[region].name + "): " + what);
    }
  }

  void check_departures(const TickRecord& record) const {
    const int tick = record.tick.tick;
    int fleet = roads_.count();
    for (int i = 0; i < world_.city.size(); ++i) {
      const Departures& said = record.exchange.departures[i];
      const int here = said.vacant + said.low_battery + said.plugged;
      require(here == roads_.held_by(i), tick, i,
              "has " + std::to_string(here) + " vehicles, was handed " + std::to_string(roads_.held_by(i)));
      require(said.plugged <= said.points, tick, i,
              std::to_string(said.plugged) + " points in use, " + std::to_string(said.points) + " work");
      fleet += here;
    }
    require(fleet == world_.city.fleet.vehicles, tick, 0, "plants and roads together are not the fleet");
  }

  void check_plan(const Plan& plan, const std::vector<Report>& reports) const {
    std::vector<int> vacant(reports.size(), 0);
    std::vector<int> low_battery(reports.size(), 0);
    for (const auto& move : plan.moves) {
      require(move.from >= 0 && move.from < static_cast<int>(reports.size()), plan.tick, 0,
              "a plan names region " + std::to_string(move.from));
      (move.errand == Errand::rebalance ? vacant : low_battery)[move.from] += move.count;
    }
    for (const auto& report : reports) {
      require(vacant[report.region] <= report.vacant && low_battery[report.region] <= report.low_battery, plan.tick,
              report.region, "is planned to send more vehicles than it reported");
    }
  }

  const World& world_;
  const Roads& roads_;
};

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

/// Every region that is due has spoken, of this tick and in its turn.
void check_complete(const Tick& tick, const Exchange& exchange) {
  const auto in_turn = [&](const auto& messages) {
    bool holds = messages.size() == tick.due.size();
    for (std::size_t i = 0; holds && i < messages.size(); ++i) {
      holds = messages[i].tick == tick.tick && messages[i].region == tick.due[i];
    }
    return holds;
  };
  if (!in_turn(exchange.departures) || (tick.plan_due && !in_turn(exchange.reports)) ||
      tick.plan_due != exchange.plan.has_value()) {
    throw run_failed("tick " + std::to_string(tick.tick) + ": reports, plan or departures are missing");
  }
}

}  // namespace

void run_day(const World& world, Players& players, const std::function<void(const TickRecord&)>& observe) {
  Roads roads(draw_fleet(world));
  const Checks checks(world, roads);
  for (int tick = 0; tick < world.clock.ticks(); ++tick) {
    TickRecord record;
    record.faults = players.faults(tick);
    record.tick = announce(world, tick, roads, record.faults);
    record.exchange = players.play(record.tick);
    check_complete(record.tick, record.exchange);
    for (const auto& departures : record.exchange.departures) {
      roads.take(departures, world.clock.minute_of(tick + 1));
    }
    checks.check(record);
    observe(record);
  }
}

}  // namespace evbal
