#include "tools/fit/car_values.hpp"

#include "common/error.hpp"
#include "coordinator/balancing/arcs.hpp"
#include "coordinator/balancing/discrete_distribution.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/convex/linear_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

// A day planned at once
// =====================
//
// Cars are a fluid, in the steps k = 0..K-1 of the day. They start where the first passengers are.
//
//   x_ij(k)   cars that drive empty from i to j, km w_ij
//   z_i(k,m)  cars in i in step k that are the m-th part of those there, between two neighbouring values v of the
//             number of passengers M_i(k), a Poisson count. Such a car gets a passenger with q = P(M >= v)
//
//   sum_m z_i(k,m) + sum_j x_ij(k)  =  sum_m (1 - q) z_i(k-1,m)  +  those that arrive in i        row (i, k)
//   min  sum w_ij x_ij(k)  -  p sum q z_i(k,m)
//
// A passenger gets out where the region's trips go, after `pickup` and the minutes of the way. Who arrives within a
// step counts in it for the share of the step that is left, and with the rest in the next. p is the mean km of a trip.
// The row's multiplier is the value. A thousandth of a car appears in each region and step: where no car ever comes the
// multiplier would else be anything between what one more is worth and what it costs to bring one there.

namespace evbal {
namespace {

constexpr double least = 1.0 / 8.0;  // of a Poisson count's values, so few parts of cars
constexpr double more = 1e-3;        // cars
constexpr int start_minutes = 120;   // of the day, whose passengers say where cars start

class DayProgram {
 public:
  DayProgram(const City& city, const CityModel& model, DayKind kind)
      : city_(city),
        model_(model),
        demand_(model.demand.seasonal.mean.at(static_cast<std::size_t>(kind))),
        K_(model.steps()),
        rows_(city.regions.size() * static_cast<std::size_t>(K_)),
        lp_(ConvexProgram{}) {
    const double cars = city.fleet.vehicles - charging(kind);
    start_ = demand_.leftCols(std::clamp(start_minutes / model.step_minutes, 1, K_)).rowwise().sum();
    start_ *= start_.sum() > 0.0 ? cars / start_.sum() : 0.0;
    const double price = trip_km();
    const std::vector<Arc> arcs =
        vacant_arcs(city.km, std::numeric_limits<double>::infinity(), BalancingParameters{}.neighbours);
    for (int k = 0; k < K_; ++k) {
      for (const Arc& arc : arcs) {
        drive(k, arc);
      }
      const std::vector<std::vector<TripShare>> trips = trips_by_origin(k);
      for (int i = 0; i < city.size(); ++i) {
        serve(k, i, trips[static_cast<std::size_t>(i)], price);
      }
    }
    write_rows();
  }

  // N x K
  Eigen::MatrixXd values() const {
    const std::optional<Eigen::VectorXd> multipliers = lp_.multipliers();
    if (!multipliers) {
      throw run_failed("the values of cars in " + city_.name + " could not be computed: no day is the best");
    }
    return ((-1000.0 * *multipliers).array().round().max(0.0) / 1000.0 + 0.0).reshaped(city_.size(), K_);
  }

 private:
  using Entry = std::pair<int, double>;  // column and coefficient

  // Cars that are plugged in on average.
  double charging(DayKind kind) const {
    const double sessions = model_.completions.seasonal.mean.at(static_cast<std::size_t>(kind)).sum();
    return std::min<double>(city_.fleet.vehicles, sessions * model_.mean_session_minutes / (K_ * model_.step_minutes));
  }

  // Mean over the passengers of the day.
  double trip_km() const {
    double km = 0.0;
    for (int k = 0; k < K_; ++k) {
      for (const auto& [from, to, share] : model_.trips_at(minute(k))) {
        km += demand_(from, k) * share * city_.km(from, to);
      }
    }
    return km / std::max(1.0, demand_.sum());
  }

  std::vector<std::vector<TripShare>> trips_by_origin(int k) const {
    std::vector<std::vector<TripShare>> by_origin(city_.regions.size());
    for (const TripShare& trips : model_.trips_at(minute(k))) {
      by_origin[static_cast<std::size_t>(trips.origin)].push_back(trips);
    }
    return by_origin;
  }

  int minute(int k) const { return model_.day_start + k * model_.step_minutes; }

  void drive(int k, const Arc& arc) {
    const int column = lp_.add_column(0.0, ConvexProgram::infinity, arc.km);
    leave(k, arc.from, column);
    arrive(k, arc.to, city_.minutes(arc.from, arc.to), column, 1.0);
  }

  void serve(int k, int i, const std::vector<TripShare>& trips, double price) {
    const DiscreteDistribution passengers = negative_binomial(demand_(i, k), demand_(i, k), least);
    double from = 0.0;
    double served = 1.0;
    for (std::size_t m = 0; m < passengers.values.size(); ++m) {
      if (passengers.values[m] > from) {
        part(k, i, passengers.values[m] - from, served, trips, price);
        from = passengers.values[m];
      }
      served -= passengers.probabilities[m];
    }
    part(k, i, ConvexProgram::infinity, 0.0, trips, price);
  }

  // Cars of which the share `served` gets a passenger.
  void part(int k, int i, double most, double served, const std::vector<TripShare>& trips, double price) {
    const int column = lp_.add_column(0.0, most, -price * served);
    leave(k, i, column);
    enter(k + 1, i, column, 1.0 - served);
    for (std::size_t trip = 0; served > 0.0 && trip < trips.size(); ++trip) {
      const auto& [from, to, share] = trips[trip];
      arrive(k, to, BalancingParameters{}.flow_pickup + city_.minutes(from, to), column, served * share);
    }
  }

  void leave(int k, int i, int column) { add(k, i, column, 1.0); }

  void enter(int k, int i, int column, double share) {
    if (k < K_) {
      add(k, i, column, -share);
    }
  }

  void arrive(int k, int j, double minutes, int column, double share) {
    const double steps = minutes / model_.step_minutes;
    const int whole = static_cast<int>(steps);
    const double late = steps - whole;
    enter(k + whole, j, column, share * (1.0 - late));
    enter(k + whole + 1, j, column, share * late);
  }

  // Columns are written one after the other, so that what a row has of one stands at its end.
  void add(int k, int i, int column, double coefficient) {
    std::vector<Entry>& row = rows_[static_cast<std::size_t>(k) * city_.regions.size() + static_cast<std::size_t>(i)];
    if (!row.empty() && row.back().first == column) {
      row.back().second += coefficient;
    } else {
      row.emplace_back(column, coefficient);
    }
  }

  void write_rows() {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (const auto& [column, coefficient] : rows_[r]) {
        lp_.add(column, coefficient);
      }
      const double cars = more + (r < city_.regions.size() ? start_(static_cast<Eigen::Index>(r)) : 0.0);
      lp_.end_row(cars, cars);
    }
  }

  const City& city_;
  const CityModel& model_;
  const Eigen::MatrixXd& demand_;
  int K_;
  Eigen::VectorXd start_;
  std::vector<std::vector<Entry>> rows_;  // by step and region
  LinearProgram lp_;
};

}  // namespace

Eigen::MatrixXd car_values(const City& city, const CityModel& model, DayKind kind) {
  return DayProgram(city, model, kind).values();
}

}  // namespace evbal
