#include "coordinator/planning/coordinator.hpp"

#include "agents/protocol/bytes.hpp"
#include "common/error.hpp"
#include "coordinator/ambiguity/gaussian_samples.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "coordinator/balancing/make_whole.hpp"
#include "coordinator/forecast/foreknowledge.hpp"
#include "coordinator/planning/planning_data.hpp"

#include <cassert>
#include <utility>

namespace evbal {
namespace {

constexpr int demand_samples = 50;

Balancer engine_balancer(const PlanningSettings& settings) {
  return [parameters = settings.balancing, engine = settings.engine](const std::string& controller,
                                                                     const PlanningData& data) {
    return balance(controller, parameters, data, engine);
  };
}

void check_fit(const City& city, const DayClock& clock, const PlanningSettings& settings, const CityModel& model) {
  const std::string file = model_file(settings, city).string();
  const auto refuse = [&](const std::string& what) {
    throw bad_input(file, 0, what + "; fit a model to this city with `evbal fit`");
  };
  if (model.regions() != city.size()) {
    refuse("the model has " + std::to_string(model.regions()) + " regions, the city " + std::to_string(city.size()));
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

/// The reports in the order of their regions.
std::vector<Report> by_region(int tick, const std::vector<Report>& reports, int regions) {
  const auto refuse = [&](int region, const std::string& what) {
    throw run_failed("tick " + std::to_string(tick) + ": the report of region " + std::to_string(region) + " " + what);
  };
  std::vector<const Report*> found(static_cast<std::size_t>(regions), nullptr);
  for (const Report& report : reports) {
    if (report.region < 0 || report.region >= regions) {
      refuse(report.region, "is of no region of this city");
    }
    if (report.tick != tick) {
      refuse(report.region, "is of tick " + std::to_string(report.tick));
    }
    if (std::exchange(found[static_cast<std::size_t>(report.region)], &report) != nullptr) {
      refuse(report.region, "came twice");
    }
  }
  std::vector<Report> ordered;
  ordered.reserve(found.size());
  for (std::size_t region = 0; region < found.size(); ++region) {
    if (found[region] == nullptr) {
      refuse(static_cast<int>(region), "is missing");
    }
    ordered.push_back(*found[region]);
  }
  return ordered;
}

Eigen::VectorXd each(const std::vector<Report>& reports, std::int32_t Report::*field) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(reports.size()));
  for (const Report& report : reports) {
    out(report.region) = report.*field;
  }
  return out;
}

void add_moves(std::vector<Move>& moves, Errand errand, const std::vector<Flow>& flows, const Eigen::VectorXd& have) {
  for (const WholeFlow& flow : make_whole(flows, have.cast<int>())) {
    moves.push_back({flow.from, flow.to, flow.vehicles, errand});
  }
}

}  // namespace

Coordinator::Coordinator(const City& city, const DayClock& clock, const std::string& date,
                         const PlanningSettings& settings, CityModel model)
    : Coordinator(city, clock, date, settings, std::move(model), engine_balancer(settings)) {}

Coordinator::Coordinator(const City& city, const DayClock& clock, const std::string& date, PlanningSettings settings,
                         CityModel model, Balancer balancer)
    : clock_(clock),
      settings_(std::move(settings)),
      model_(std::move(model)),
      km_(city.km),
      minutes_(city.minutes),
      session_quantiles_(city.charging.session_quantiles),
      same_step_dropoffs_(evbal::same_step_dropoffs(city, clock.step)),
      has_points_((city.points().array() > 0).cast<double>()),
      told_(announced_demand({}, model_.regions())),
      ladder_(settings_.controller, std::move(balancer)) {
  check_fit(city, clock_, settings_, model_);
  const DayKind kind = model_.kind(date);
  const int start = clock_.start - model_.day_start;
  demand_ = std::make_unique<SeasonalForecaster>(model_.demand.seasonal, kind, start);
  completions_ = std::make_unique<SeasonalForecaster>(model_.completions.seasonal, kind, start);
}

void Coordinator::foresee(const Eigen::MatrixXd& demand_by_tick) {
  assert(demand_by_tick.rows() == model_.regions() && demand_by_tick.cols() == clock_.ticks());
  demand_ = std::make_unique<Foreknowledge>(demand_by_tick, clock_.tick, clock_.step);
}

PlanningData Coordinator::data(int minute, const std::vector<Report>& reports) const {
  const int tau = horizon_at(clock_, minute, settings_.balancing.tau);
  PlanningData data;
  data.km = km_;
  data.minutes = minutes_;
  data.state = fleet_state(reports, minute, clock_.step, tau);
  data.points = points_ahead(reports, tau);
  data.demand = moment_set(model_.demand.errors, told_.as_announced(demand_->forecast(minute, tau), clock_.step),
                           demand_->scale(minute, tau));
  data.demand_samples = gaussian_samples(data.demand, demand_samples);
  data.completions =
      moment_set(model_.completions.errors, has_points_.asDiagonal() * completions_->forecast(minute, tau),
                 has_points_.asDiagonal() * completions_->scale(minute, tau));
  data.free_points = free_points(reports, minute, clock_.step, session_quantiles_, data.completions);
  data.same_step_dropoffs = same_step_dropoffs_;
  for (int step = 0; step < tau; ++step) {
    data.transitions.push_back(model_.transitions_at(clock_.start + minute + step * clock_.step));
  }
  data.step_minutes = clock_.step;
  data.mean_session_minutes = model_.mean_session_minutes;
  return data;
}

/// Takes what the reports count; gives them back in the order of their regions.
std::vector<Report> Coordinator::observe(const Tick& tick, const std::vector<Report>& reports) {
  assert(clock_.plan_due(tick.tick));
  std::vector<Report> ordered = by_region(tick.tick, reports, model_.regions());
  const int minute = clock_.minute_of(tick.tick);
  demand_->observe(minute, told_.as_usual(each(ordered, &Report::demand), minute - told_at_));
  completions_->observe(minute, each(ordered, &Report::completions));
  told_ = announced_demand(settings_.foresees() ? std::vector<Effect>{} : tick.effects, model_.regions());
  told_at_ = minute;
  return ordered;
}

std::string Coordinator::memory() const {
  return to_bytes(ladder_.memory());
}

void Coordinator::recall(const Tick& tick, const std::vector<Report>& reports, const std::string& memory) {
  observe(tick, reports);
  ladder_.recall(from_bytes<LadderMemory>(memory));
}

Plan Coordinator::plan(const Tick& tick, const std::vector<Report>& reports) {
  const PlanningData known = data(clock_.minute_of(tick.tick), observe(tick, reports));
  Decision decision = ladder_.decide(known);

  Plan plan;
  plan.tick = tick.tick;
  add_moves(plan.moves, Errand::rebalance, decision.vacant, known.state.vacant);
  add_moves(plan.moves, Errand::charge, decision.low_battery, known.state.low_battery);
  plan.provenance = std::move(decision.provenance);
  if (plan.provenance.iterations > 0) {
    plan.provenance.engine = settings_.engine.name;
  }
  return plan;
}

}  // namespace evbal
