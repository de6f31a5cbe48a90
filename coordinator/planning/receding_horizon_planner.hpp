#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/world/city.hpp"
#include "common/clock.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "coordinator/filter/fleet_filter.hpp"
#include "coordinator/forecast/forecaster.hpp"
#include "coordinator/planning/announced.hpp"
#include "coordinator/planning/city_model.hpp"
#include "coordinator/planning/fleet_estimate.hpp"
#include "coordinator/planning/ladder.hpp"
#include "coordinator/planning/report_check.hpp"
#include "coordinator/planning/settings.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace evbal {

/// Solves by the controllers given, as the settings say; names that are not among them are those of evbal's own.
Balancer balancer_of(const PlanningSettings& settings, std::vector<Controller> controllers = {});

/// From reports to a plan, over a horizon that recedes: forecast, uncertainty set, balancing problem, whole vehicles.
/// Reports are not trusted: one that cannot be true, is not of now or does not come is rejected, the plan says why, and
/// an estimate stands in for it.
class RecedingHorizonPlanner {
 public:
  /// `city` with the scenario's overrides, `date` as "2008-06-03", `model` fitted to this city. Throws Error{bad_input}
  /// if the model does not fit the city, the clock or the horizon.
  RecedingHorizonPlanner(const City& city, const DayClock& clock, const std::string& date,
                         const PlanningSettings& settings, CityModel model);

  /// The same with another solver.
  RecedingHorizonPlanner(const City& city, const DayClock& clock, const std::string& date, PlanningSettings settings,
                         CityModel model, Balancer balancer);

  /// Tells what the demand will be, N x ticks of the day, in place of a forecast and of what is announced: before the
  /// first plan, and only for controllers that foresee.
  void foresee(const Eigen::MatrixXd& demand_by_tick);

  /// The plan of `tick`, which is due; `reports` are what came, in any order. To be called for every tick at
  /// which a plan is due, in turn: forecasts live on it. The Origin is left to the process that publishes the plan.
  Plan plan(const Tick& tick, const std::vector<Report>& reports);

  /// In place of plan() at a tick that another plans: takes the reports. follow() comes next.
  void hear(const Tick& tick, const std::vector<Report>& reports) { observe(tick, reports); }

  /// After plan() or hear() at the same tick: these are the moves that were really planned.
  void follow(std::vector<Move> moves) { last_.moves = std::move(moves); }

  /// What later plans depend on beside the reports, as bytes.
  std::string memory() const;

  /// In place of plan(), for a planner that takes over from another: the tick's reports, and what the other's memory()
  /// was after its plan. Throws as plan() does.
  void recall(const Tick& tick, const std::vector<Report>& reports, const std::string& memory);

 private:
  /// Takes what the reports say, as far as they are believed; gives them, or estimates, by region.
  std::vector<Report> observe(const Tick& tick, const std::vector<Report>& reports);

  /// The reports as the filter leaves them, by region; notes what it found. `checked.good` are then those that teach
  /// the forecasts.
  std::vector<Report> filtered(const Tick& tick, CheckedReports& checked, Provenance& found);

  /// Demand of `tau` steps from the last reports on, N x tau or more, as these let expect and as announced.
  const Eigen::MatrixXd& demand_ahead(int tau);

  /// What was to be expected of the time between two plans.
  WindowOutlook outlook(int from, int until);

  /// Short trips of a period of the model and a window between plans: worked out anew only when either changes.
  struct KnownShortTrips {
    const std::vector<TripShare>* of = nullptr;
    int window = 0;
    std::vector<ShortTrips> trips;
  };

  /// What the innovation test multiplies standard deviations by, by region: 1 without one.
  struct Inflation {
    Eigen::VectorXd demand;
    Eigen::VectorXd completions;
  };
  Inflation inflation_at(int minute) const;

  PlanningData data(int minute, const std::vector<Report>& reports, const Inflation& by);

  DayClock clock_;
  PlanningSettings settings_;
  CityModel model_;
  DayKind kind_;
  Eigen::MatrixXd km_;
  Eigen::MatrixXd minutes_;
  std::vector<double> session_quantiles_;
  bool top_up_;                 ///< whether the world knows top-up charging
  Eigen::VectorXd has_points_;  ///< 1 where the city has points, working or not, else 0
  std::unique_ptr<Forecaster> demand_;
  bool foresees_ = false;  ///< whether demand_ is the true demand
  std::unique_ptr<Forecaster> completions_;
  ReportBounds bounds_;
  FleetEstimate fleet_;
  std::optional<FleetFilter> filter_;  ///< in place of fleet_, unless sensor faults are ignored
  Eigen::VectorXd vacant_variance_;    ///< N, of the number of vacant vehicles: 0 where a report is believed
  KnownShortTrips short_trips_;
  AnnouncedDemand told_;          ///< with the last plan's tick
  Eigen::MatrixXd demand_ahead_;  ///< from then on; empty until it is asked for
  Plan last_;
  Ladder ladder_;
};

}  // namespace evbal
