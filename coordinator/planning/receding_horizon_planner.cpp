#include "coordinator/planning/receding_horizon_planner.hpp"

#include "agents/protocol/bytes.hpp"
#include "common/contract.hpp"
#include "common/error.hpp"
#include "coordinator/ambiguity/gaussian_samples.hpp"
#include "coordinator/balancing/round_to_vehicles.hpp"
#include "coordinator/balancing/send_limits.hpp"
#include "coordinator/balancing/top_up.hpp"
#include "coordinator/forecast/foreknowledge.hpp"
#include "coordinator/planning/car_worth.hpp"
#include "coordinator/planning/filter_outlook.hpp"
#include "coordinator/planning/freed_cars.hpp"
#include "coordinator/planning/planning_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace evbal {

/// What a planner cannot find out again from the reports of the day.
struct Memory {
  LadderMemory ladder;
  std::vector<Move> moves;  ///< of the last plan
};

namespace {

constexpr int demand_samples = 50;

void check_fit(const City& city, const DayClock& clock, const PlanningSettings& settings, const CityModel& model) {
  const std::string file = model_file(settings, city).string();
  const auto refuse = [&](const std::string& what) {
    throw bad_input(file, 0, what + "; fit a model to this city with `evbal fit`");
  };
  if (model.city != city.name) {
    refuse("the model is of " + model.city + ", the city is " + city.name);
  }
  if (model.regions() != city.size()) {
    refuse("the model has " + std::to_string(model.regions()) + " regions, the city " + std::to_string(city.size()));
  }
  if (model.day_start != city.day_start) {
    refuse("the model's day starts at " + time_of_day({.start = model.day_start}, 0) + ", the city's at " +
           time_of_day({.start = city.day_start}, 0));
  }
  if (model.step_minutes == city.step_minutes && model.steps() != city.steps_per_day()) {
    refuse("the model's day has " + std::to_string(model.steps()) + " steps, the city's " +
           std::to_string(city.steps_per_day()));
  }
  if (model.step_minutes != clock.step) {
    refuse("the model has steps of " + std::to_string(model.step_minutes) + " min, the clock of " +
           std::to_string(clock.step) + " min");
  }
  if (model.leads() < settings.balancing.tau) {
    refuse("the model forecasts " + std::to_string(model.leads()) + " steps, balancing.tau is " +
           std::to_string(settings.balancing.tau));
  }
}

/// A count of the reports that are believed, by region; NaN elsewhere: what was not heard of teaches a forecast
/// nothing.
Eigen::VectorXd heard(const std::vector<std::optional<Report>>& good, std::int32_t Report::*field) {
  Eigen::VectorXd counts(static_cast<Eigen::Index>(good.size()));
  for (std::size_t i = 0; i < good.size(); ++i) {
    counts(static_cast<Eigen::Index>(i)) = good[i] ? *good[i].*field : std::numeric_limits<double>::quiet_NaN();
  }
  return counts;
}

/// An engine that always fails.
Solution failing(const ConvexProgram& /*program*/, const EngineSettings& /*settings*/) {
  return {{}, refusal("the engine fails, by a fault")};
}

/// The engine as the solver's faults leave it.
EngineSettings under_faults(EngineSettings engine, const std::vector<Effect>& effects) {
  for (const Effect& effect : effects) {
    if (effect.type == EffectType::solver_fail) {
      engine.own = failing;
    } else if (effect.type == EffectType::solver_starve) {
      engine.max_iterations = std::min(engine.max_iterations, static_cast<int>(std::lround(effect.magnitude)));
    }
  }
  return engine;
}

/// Adds the variance of the number of vacant vehicles (N) to that of demand: a vehicle too few counts as much as a
/// passenger too many.
void add_variance(MomentSet& demand, const Eigen::VectorXd& variance) {
  const Eigen::Index n = variance.size();
  for (Eigen::Index i = 0; i < demand.deviation.size(); ++i) {
    const double more = variance(i % n);
    demand.deviation(i) = more > 0.0 ? std::hypot(demand.deviation(i), std::sqrt(more)) : demand.deviation(i);
  }
}

/// A decision in whole vehicles that are there and get there, by (errand, from, to).
std::vector<Move> moves_of(const Decision& decision, const PlanningData& data) {
  std::vector<Arc> to_charge;
  for (const Flow& flow : decision.low_battery) {
    to_charge.push_back({flow.from, flow.to, data.km(flow.from, flow.to)});
  }
  std::ranges::stable_sort(to_charge, {}, &Arc::from);
  const auto vacant = round_to_vehicles(decision.vacant, data.state.vacant.cast<int>());
  const auto low_battery =
      round_to_vehicles(decision.low_battery, data.state.low_battery.cast<int>(), reach_limits(data.state, to_charge));
  std::vector<Move> moves;
  const auto add = [&](Errand errand, const std::vector<VehicleFlow>& flows) {
    for (const VehicleFlow& flow : flows) {
      moves.push_back({flow.from, flow.to, flow.vehicles, errand});
    }
  };
  add(Errand::rebalance, vacant);
  add(Errand::charge, low_battery);
  add(Errand::charge, whole_top_ups(decision.top_up, data, vacant));
  std::ranges::sort(moves, {}, [](const Move& move) { return std::tuple(move.errand, move.from, move.to); });
  return moves;
}

}  // namespace

Balancer balancer_of(const PlanningSettings& settings, std::vector<Controller> controllers) {
  return [parameters = settings.balancing, controllers = std::move(controllers)](
             const std::string& name, const PlanningData& data, const EngineSettings& engine) {
    const auto own = std::ranges::find(controllers, name, &Controller::name);
    return own == controllers.end() ? balance(name, parameters, data, engine) : balance(*own, parameters, data, engine);
  };
}

RecedingHorizonPlanner::RecedingHorizonPlanner(const City& city, const DayClock& clock, const std::string& date,
                                               const PlanningSettings& settings, CityModel model)
    : RecedingHorizonPlanner(city, clock, date, settings, std::move(model), balancer_of(settings)) {}

RecedingHorizonPlanner::RecedingHorizonPlanner(const City& city, const DayClock& clock, const std::string& date,
                                               PlanningSettings settings, CityModel model, Balancer balancer)
    : clock_(clock),
      settings_(std::move(settings)),
      model_(std::move(model)),
      kind_(model_.kind(date)),
      km_(city.km),
      minutes_(city.minutes),
      session_quantiles_(city.charging.session_quantiles),
      top_up_(city.charging.top_up),
      has_points_((city.points().array() > 0).cast<double>()),
      bounds_{city.fleet.vehicles, {}, clock},
      fleet_(
          {city.points().cast<double>(), city.minutes, static_cast<double>(clock.step), model_.mean_session_minutes}),
      told_(announced_demand({}, model_.regions())),
      ladder_(settings_.controller, std::move(balancer)) {
  check_fit(city, clock_, settings_, model_);
  const Eigen::VectorXi points = city.points();
  bounds_.points.assign(points.begin(), points.end());
  const int start = clock_.start - model_.day_start;
  if (settings_.sensor_faults != SensorFaults::ignore) {
    filter_.emplace(filter_model(city, clock_));
  }
  demand_ = std::make_unique<SeasonalForecaster>(model_.demand.seasonal, kind_, start);
  completions_ = std::make_unique<SeasonalForecaster>(model_.completions.seasonal, kind_, start);
}

void RecedingHorizonPlanner::foresee(const Eigen::MatrixXd& demand_by_tick) {
  EVBAL_EXPECT(demand_by_tick.rows() == model_.regions() && demand_by_tick.cols() == clock_.ticks(),
               "demand of every region and tick of the day");
  demand_ = std::make_unique<Foreknowledge>(demand_by_tick, clock_.tick, clock_.step);
  foresees_ = true;
}

RecedingHorizonPlanner::Inflation RecedingHorizonPlanner::inflation_at(int minute) const {
  const Eigen::VectorXd none = Eigen::VectorXd::Ones(model_.regions());
  return settings_.innovation_test
             ? Inflation{inflation(model_.demand.errors, demand_->normalised_innovation(minute)),
                         inflation(model_.completions.errors, completions_->normalised_innovation(minute))}
             : Inflation{none, none};
}

const Eigen::MatrixXd& RecedingHorizonPlanner::demand_ahead(int tau) {
  if (demand_ahead_.cols() < tau) {
    demand_ahead_ = told_.as_announced(demand_->forecast(clock_.minute_of(last_.tick), tau), clock_.step);
  }
  return demand_ahead_;
}

PlanningData RecedingHorizonPlanner::data(int minute, const std::vector<Report>& reports, const Inflation& by) {
  const int tau = horizon_at(clock_, minute, settings_.balancing.tau);
  PlanningData data;
  data.km = km_;
  data.minutes = minutes_;
  data.state = fleet_state(reports, minute, clock_.step, tau);
  data.state.chargeable *= top_up_ ? 1.0 : 0.0;
  data.points = points_ahead(reports, tau);
  data.demand = moment_set(model_.demand.errors, demand_ahead(tau), demand_->scale(minute, tau));
  inflate(data.demand, by.demand);
  add_variance(data.demand, vacant_variance_);
  data.demand_samples = gaussian_samples(data.demand, draws_samples(settings_.controller) ? demand_samples : 0);
  data.completions =
      moment_set(model_.completions.errors, has_points_.asDiagonal() * completions_->forecast(minute, tau),
                 has_points_.asDiagonal() * completions_->scale(minute, tau));
  inflate(data.completions, by.completions);
  data.free_points = free_points(reports, minute, clock_.step, session_quantiles_, data.completions);
  data.turnover = model_.turnover;
  for (int step = 0; step < tau; ++step) {
    data.transitions.push_back(model_.transitions_at(clock_.start + minute + step * clock_.step));
  }
  data.step_minutes = clock_.step;
  data.mean_session_minutes = model_.mean_session_minutes;
  data.freed = freed_cars(data, reports, minute, slots_at(clock_, minute, settings_.balancing), session_quantiles_,
                          model_.trips_at(clock_.start + minute), settings_.balancing);
  if (settings_.balancing.flow_value > 0.0) {
    data.worth = car_worth(data, model_, kind_, clock_.start + minute, settings_.balancing);
  }
  data.start = ladder_.memory().start;
  return data;
}

std::vector<Report> RecedingHorizonPlanner::observe(const Tick& tick, const std::vector<Report>& reports) {
  EVBAL_EXPECT(clock_.plan_due(tick.tick), "a tick at which a plan is due");
  const int minute = clock_.minute_of(tick.tick);
  const int before = clock_.minute_of(last_.tick);
  CheckedReports checked = check_reports(reports, tick.tick, last_.tick, bounds_);
  Provenance found;
  std::vector<Report> believed;
  if (filter_) {
    believed = filtered(tick, checked, found);
  } else {
    fleet_.advance(minute, last_.moves, model_.transitions_at(clock_.start + before));
    believed = fleet_.settle(tick.tick, checked.good);
    vacant_variance_ = fleet_.variance();
  }
  demand_->observe(minute, told_.as_usual(heard(checked.good, &Report::demand), minute - before));
  completions_->observe(minute, heard(checked.good, &Report::completions));
  told_ = announced_demand(foresees_ ? std::vector<Effect>{} : tick.effects, model_.regions());
  demand_ahead_ = {};
  last_ = {};
  last_.tick = tick.tick;
  last_.provenance = std::move(found);
  last_.provenance.rejected = std::move(checked.rejected);
  return believed;
}

WindowOutlook RecedingHorizonPlanner::outlook(int from, int until) {
  const std::vector<TripShare>& trips = model_.trips_at(clock_.start + from);
  if (short_trips_.of != &trips || short_trips_.window != until - from) {
    short_trips_ = {&trips, until - from, short_trips(trips, minutes_, until - from, clock_.tick)};
  }
  const Eigen::VectorXd demand = demand_ahead(1).col(0) * (until - from) / clock_.step;
  return {short_trips_.trips, demand, model_.turnover.demand.linear.front()};
}

std::vector<Report> RecedingHorizonPlanner::filtered(const Tick& tick, CheckedReports& checked, Provenance& found) {
  const int minute = clock_.minute_of(tick.tick);
  FleetFilter::Result result =
      filter_->observe(tick, minute, checked.readable, last_.moves, outlook(clock_.minute_of(last_.tick), minute));
  found.flags = std::move(result.flags);
  found.innovations = std::move(result.innovations);
  vacant_variance_ = filter_->variance();
  const bool isolate = settings_.sensor_faults == SensorFaults::isolate;
  for (SensorFlag& flag : found.flags) {
    const auto region = static_cast<std::size_t>(flag.region);
    flag.isolated = isolate || !checked.good[region];
    if (isolate) {
      checked.good[region] = result.reports[region];
    }
  }
  for (std::size_t i = 0; i < result.reports.size(); ++i) {
    if (checked.good[i] && !isolate) {
      vacant_variance_(static_cast<Eigen::Index>(i)) = 0.0;
      result.reports[i] = *checked.good[i];
    }
  }
  return result.reports;
}

std::string RecedingHorizonPlanner::memory() const {
  return to_bytes(Memory{ladder_.memory(), last_.moves});
}

void RecedingHorizonPlanner::recall(const Tick& tick, const std::vector<Report>& reports, const std::string& memory) {
  observe(tick, reports);
  auto known = from_bytes<Memory>(memory);
  ladder_.recall(std::move(known.ladder));
  last_.moves = std::move(known.moves);
}

Plan RecedingHorizonPlanner::plan(const Tick& tick, const std::vector<Report>& reports) {
  const int minute = clock_.minute_of(tick.tick);
  const std::vector<Report> believed = observe(tick, reports);
  const Inflation by = inflation_at(minute);
  const PlanningData known = data(minute, believed, by);
  Decision decision = ladder_.decide(minute, known, under_faults(settings_.engine, tick.effects));
  last_.moves = moves_of(decision, known);
  decision.provenance.rejected = std::move(last_.provenance.rejected);
  decision.provenance.flags = std::move(last_.provenance.flags);
  decision.provenance.innovations = std::move(last_.provenance.innovations);
  last_.provenance = std::move(decision.provenance);
  if (last_.provenance.iterations > 0) {
    last_.provenance.engine = settings_.engine.name;
  }
  last_.provenance.demand_widened = by.demand.maxCoeff();
  last_.provenance.completions_widened = by.completions.maxCoeff();
  return last_;
}

}  // namespace evbal
