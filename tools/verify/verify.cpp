#include "tools/verify/verify.hpp"

#include "common/error.hpp"
#include "common/random.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "coordinator/balancing/worst_case.hpp"
#include "experiments/bound/bound_front.hpp"
#include "tools/samples/random_planning_data.hpp"
#include "tools/verify/cheapest_day.hpp"
#include "tools/verify/csdp.hpp"
#include "tools/verify/flow_by_clp.hpp"
#include "tools/verify/inner_problem.hpp"
#include "tools/verify/moment_problem.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <sstream>
#include <utility>

namespace evbal {
namespace {

constexpr double semidefinite_tolerance = 1e-5;
constexpr double tolerance = 1e-6;

void meet(Comparison& comparison, double ours, double theirs, const std::string& where) {
  const double difference = std::abs(ours - theirs) / std::max(1.0, std::abs(theirs));
  ++comparison.cases;
  if (!(difference <= comparison.largest)) {
    comparison.largest = difference;
    comparison.where = where;
  }
}

Eigen::VectorXd normals(RandomStream& random, Eigen::Index size) {
  return Eigen::VectorXd::NullaryExpr(size, [&] { return random.normal(); });
}

MomentSet random_set(RandomStream& random, Eigen::Index size) {
  MomentSet set;
  set.mean = 3.0 * normals(random, size);
  set.deviation = Eigen::VectorXd::NullaryExpr(size, [&] { return random.uniform(0.3, 2.0); });
  set.factors = Eigen::MatrixXd::NullaryExpr(size, 2, [&] { return random.normal(); });
  return set;
}

// The set around the forecast of two steps from `minute` of a working day, restricted to its busiest entries.
MomentSet fitted_set(const SeriesModel& series, int minute, Eigen::Index entries) {
  const SeasonalForecaster forecaster(series.seasonal, DayKind::weekday);
  const int tau = std::min(2, series.errors.leads());
  const MomentSet whole = moment_set(series.errors, forecaster.forecast(minute, tau), forecaster.scale(minute, tau));
  std::vector<Eigen::Index> busiest(static_cast<std::size_t>(whole.mean.size()));
  std::iota(busiest.begin(), busiest.end(), 0);
  std::ranges::stable_sort(busiest, std::greater{}, [&](Eigen::Index i) { return whole.mean(i); });
  busiest.resize(std::min(busiest.size(), static_cast<std::size_t>(entries)));
  MomentSet set = whole;
  set.mean = whole.mean(busiest);
  set.deviation = whole.deviation(busiest);
  set.factors = whole.factors(busiest, Eigen::all);
  return set;
}

void compare_with_theorem(Comparison& comparison, const MomentSet& set, const Eigen::VectorXd& h,
                          const std::string& where) {
  const auto solution = solve_with_csdp(inner_problem(set, h));
  meet(comparison, closed_form(set, h), solution.at(0) + solution.at(1), where);
}

}  // namespace

std::vector<Comparison> compare_with_theorem(const CityModel& model) {
  std::vector<Comparison> comparisons;
  for (const bool mean_binds : {true, false}) {
    const std::string order = mean_binds ? ", g1 < g2" : ", g1 > g2";
    const auto order_thresholds = [mean_binds](MomentSet& set, double a, double b) {
      set.g1 = mean_binds ? std::min(a, b) : std::max(a, b);
      set.g2 = mean_binds ? std::max(a, b) : std::min(a, b);
    };
    Comparison random_sets{.what = "theorem 1 by CSDP, random sets" + order, .allowed = semidefinite_tolerance};
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      RandomStream random(seed, Purpose::synthetic_city, {.index = mean_binds ? 1U : 2U});
      const auto size = static_cast<Eigen::Index>(1 + seed % 8);
      MomentSet set = random_set(random, size);
      order_thresholds(set, random.uniform(0.05, 1.0), random.uniform(1.0, 4.0));
      compare_with_theorem(random_sets, set, normals(random, size), "seed " + std::to_string(seed));
    }
    comparisons.push_back(random_sets);

    Comparison fitted_sets{.what = "theorem 1 by CSDP, fitted sets" + order, .allowed = semidefinite_tolerance};
    for (const int hour : {3, 7, 11, 15}) {  // after the day's start
      for (const bool demand : {true, false}) {
        RandomStream random(static_cast<std::uint64_t>(hour), Purpose::synthetic_city, {.index = demand ? 3U : 4U});
        MomentSet set = fitted_set(demand ? model.demand : model.completions, hour * 60, 8);
        order_thresholds(set, set.g1, set.g2);
        compare_with_theorem(fitted_sets, set, normals(random, set.mean.size()),
                             (demand ? "demand, " : "completions, ") + std::to_string(hour) + " hours into the day");
      }
    }
    comparisons.push_back(fitted_sets);
  }
  return comparisons;
}

Comparison compare_with_moment_problem() {
  Comparison comparison{.what = "worst expected shortage by a moment LP", .allowed = tolerance};
  for (const double d : {-20.0, -3.0, -1.0, -0.1, 0.0, 0.1, 0.5, 1.0, 2.0, 3.0, 20.0}) {
    for (const double sigma : {0.1, 1.0, 5.0}) {
      for (const auto& [g1, g2] : {std::pair{0.0, 1.0}, {0.2, 1.4}, {1.0, 1.0}, {1.5, 3.7}, {2.0, 0.5}}) {
        std::ostringstream where;
        where << "d " << d << ", sigma " << sigma << ", g1 " << g1 << ", g2 " << g2;
        meet(comparison, worst_case_shortage(d, sigma, g1, g2).value, moment_problem(d, sigma, g1, g2), where.str());
      }
    }
  }
  return comparison;
}

std::vector<Comparison> compare_engines() {
  std::vector<Comparison> comparisons;
  for (const auto& controller : controller_names()) {
    Comparison comparison{.what = "engines cuts and ipopt, " + controller, .allowed = tolerance};
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const DataShape shape{.regions = static_cast<int>(2 + 2 * seed), .tau = static_cast<int>(1 + seed % 4)};
      const auto data = random_planning_data(seed, shape);
      const auto cuts = balance(controller, {}, data, {.name = "cuts"}).certificate;
      const auto ipopt = balance(controller, {}, data, {.name = "ipopt"}).certificate;
      const std::string where = "seed " + std::to_string(seed);
      for (const auto* certificate : {&cuts, &ipopt}) {
        if (!certificate->optimal()) {
          throw run_failed(comparison.what + ", " + where + ": " + certificate->reason);
        }
      }
      if (cuts.iterations > 0) {
        meet(comparison, cuts.objective, ipopt.objective, where);
      }
    }
    if (comparison.cases > 0) {
      comparisons.push_back(comparison);
    }
  }
  return comparisons;
}

std::vector<Comparison> compare_bounds() {
  Comparison above{.what = "bound above the best of all plays, tiny days", .allowed = tolerance};
  Comparison program{.what = "linear program of the bound by Clp, tiny days", .allowed = 2.0 * flow_gap};
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const BoundDay day = tiny_day(seed);
    for (const double price : {1.0, 4.0, 20.0}) {
      const DayBound bound = day_bound(day, {price}, [](const BoundProgress&) { return false; });
      const BoundPoint& point = bound.points.front();
      const std::string where = "seed " + std::to_string(seed) + ", price " + std::to_string(static_cast<int>(price));
      if (!point.tight || !point.up) {
        throw run_failed(program.what + ", " + where + ": the interior point does not settle");
      }
      const double cheapest = cheapest_day(day, price);
      meet(above, std::max(point.bound, cheapest), cheapest, where);
      meet(program, point.bound, flow_by_clp(time_network(day, Rounding::down), price), where + ", down");
      meet(program, price * point.up->lost + point.up->km, flow_by_clp(time_network(day, Rounding::up), price),
           where + ", up");
    }
  }
  return {above, program};
}

}  // namespace evbal
