#include "tools/fit/training_day.hpp"

#include "coordinator/planning/receding_horizon_planner.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/conductor/run_day.hpp"

#include <algorithm>
#include <deque>

namespace evbal {
namespace {

CarState on_the_road(Errand errand) {
  switch (errand) {
    case Errand::passenger:
      return CarState::occupied;
    case Errand::rebalance:
      return CarState::rebalancing;
    case Errand::charge:
      return CarState::to_charger;
  }
  return CarState::occupied;
}

CarState in_region(VehicleState state) {
  switch (state) {
    case VehicleState::vacant:
      return CarState::vacant;
    case VehicleState::low_battery:
      return CarState::low_battery;
    case VehicleState::plugged:
      return CarState::plugged;
    case VehicleState::broken:
      break;  // not on training days, which have no faults
  }
  return CarState::vacant;
}

/// Follows every vehicle through a day and counts what became of it within a step, from every plan on.
class Follower {
 public:
  Follower(const World& world, const std::vector<int>& period_starts, const std::vector<RegionPlant>& plants)
      : clock_(world.clock),
        starts_(period_starts),
        plants_(plants),
        now_(static_cast<std::size_t>(world.city.fleet.vehicles)),
        counts_(period_starts.size(), TransitionCounts(world.city.size())) {
    look();
  }

  void observe(const TickRecord& record) {
    const int minute = clock_.minute_of(record.tick.tick);
    if (!origins_.empty() && origins_.front().minute + clock_.step == minute) {
      counts_[period_at(starts_, clock_.start + origins_.front().minute)].add(origins_.front().places, now_);
      origins_.pop_front();
    }
    if (record.tick.plan_due) {
      origins_.push_back({minute, dispatched(record)});
    }
    for (const Departures& said : record.exchange.departures) {
      for (const Departure& departure : said.departures) {
        now_[static_cast<std::size_t>(departure.vehicle.id)] = {on_the_road(departure.errand), departure.to};
      }
    }
    look();
  }

  std::vector<TransitionCounts> counts() && { return std::move(counts_); }

 private:
  struct Origin {
    int minute = 0;
    std::vector<CarPlace> places;
  };

  void look() {
    for (const RegionPlant& plant : plants_) {
      for (const VehiclePlace& place : plant.census()) {
        now_[static_cast<std::size_t>(place.vehicle)] = {in_region(place.state), plant.region()};
      }
    }
  }

  /// Where cars are just after dispatch: as before, but those sent off stand where they go.
  std::vector<CarPlace> dispatched(const TickRecord& record) const {
    std::vector<CarPlace> places = now_;
    for (const Departures& said : record.exchange.departures) {
      for (const Departure& departure : said.departures) {
        if (departure.errand != Errand::passenger) {
          places[static_cast<std::size_t>(departure.vehicle.id)].region = departure.to;
        }
      }
    }
    return places;
  }

  const DayClock& clock_;
  const std::vector<int>& starts_;
  const std::vector<RegionPlant>& plants_;
  std::vector<CarPlace> now_;  ///< by vehicle
  std::deque<Origin> origins_;
  std::vector<TransitionCounts> counts_;
};

}  // namespace

TrainingDay play_training_day(const World& world, const CityModel& model, const PlanningSettings& settings,
                              const std::vector<int>& period_starts) {
  RecedingHorizonPlanner planner(world.city, world.clock, world.day.date, settings, model);
  InprocPlayers players(
      world, [&](const Tick& tick, const auto& reports) { return planner.plan(tick, reports); },
      [](int tick) { return Faults{.tick = tick, .effects = {}, .origin = {}}; });
  Follower follower(world, period_starts, players.plants());
  TrainingDay day{Eigen::MatrixXd::Zero(world.city.size(), world.clock.steps()), {}, 0, 0, 0.0};
  run_day(world, players, [&](const TickRecord& record) {
    follower.observe(record);
    const int step = world.clock.step_of(world.clock.minute_of(record.tick.tick));
    for (const Departures& said : record.exchange.departures) {
      day.completions(said.region, step) += said.completions;
      for (const Departure& departure : said.departures) {
        day.idle_km += departure.errand == Errand::passenger ? 0.0 : departure.km;
      }
      for (const Fate& fate : said.fates) {
        ++(fate.served ? day.served : day.lost);
      }
    }
  });
  day.transitions = std::move(follower).counts();
  return day;
}

}  // namespace evbal
