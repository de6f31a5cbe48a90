#include "coordinator/balancing/validate.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>

namespace evbal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Collects the first complaint only.
class Complaint {
 public:
  // Every entry within [low, high]; NaN never is. A matrix's entry is named by region and, if it has several columns,
  // by `column`.
  void require(const Eigen::MatrixXd& values, double low, double high, std::string_view what, std::string_view column) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      for (Eigen::Index j = 0; j < values.cols(); ++j) {
        if (text_.empty() && !(values(i, j) >= low && values(i, j) <= high)) {
          std::ostringstream out;
          out << what << " of region " << i;
          if (values.cols() > 1) {
            out << ", " << column << ' ' << j;
          }
          out << ": " << values(i, j) << " is not in [" << low << ", " << high << ']';
          text_ = out.str();
        }
      }
    }
  }

  // The same of a matrix that is infinite where there is no road.
  void require_or_infinite(const Eigen::MatrixXd& values, double high, std::string_view what) {
    require(values.unaryExpr([](double value) { return value == infinity ? 0.0 : value; }), 0.0, high, what, "to");
  }

  void require(double value, double low, double high, std::string_view what) {
    if (text_.empty() && !(value >= low && value <= high)) {
      std::ostringstream out;
      out << what << ": " << value << " is not in [" << low << ", " << high << ']';
      text_ = out.str();
    }
  }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// Far beyond any city, and yet no product of them is so large that a solver fails on it.
constexpr double least = std::numeric_limits<double>::min();  // above zero
constexpr double most_cars = 1e6;                             // in one region; of passengers too
constexpr double most_km = 1e6;
constexpr double most_minutes = 1e6;
constexpr double most_price = 1e6;
constexpr double most_threshold = 1e6;
constexpr double most_variance = 1e5;  // of demand over its mean; a count so wide already has millions of values

void check_state(Complaint& complaint, const FleetState& state) {
  complaint.require(state.vacant, 0.0, most_cars, "vacant vehicles", "");
  complaint.require(state.chargeable, 0.0, most_cars, "chargeable vehicles", "");
  complaint.require(state.occupied, 0.0, most_cars, "occupied vehicles", "");
  complaint.require(state.low_battery, 0.0, most_cars, "low-battery vehicles", "");
  for (std::size_t i = 0; i < state.reach.size(); ++i) {
    for (const double km : state.reach[i]) {
      complaint.require(km, 0.0, most_km, "reach of a low-battery vehicle of region " + std::to_string(i));
    }
  }
  complaint.require(state.plugged, 0.0, most_cars, "plugged vehicles", "");
  complaint.require(state.waiting, 0.0, most_cars, "waiting passengers", "");
  complaint.require(state.arriving_vacant, 0.0, most_cars, "arriving vacant vehicles", "step");
  complaint.require(state.arriving_low_battery, 0.0, most_cars, "arriving low-battery vehicles", "step");
  complaint.require(state.dropoffs_due, 0.0, most_cars, "drop-offs due", "step");
}

void check_set(Complaint& complaint, const MomentSet& set, Eigen::Index regions, const std::string& what) {
  const auto steps = set.mean.size() / regions;
  complaint.require(set.mean.reshaped(regions, steps), -most_cars, most_cars, what + ", mean", "step");
  complaint.require(set.deviation.reshaped(regions, steps), least, most_cars, what + ", deviation", "step");
  for (Eigen::Index r = 0; r < set.factors.cols(); ++r) {
    complaint.require(set.factors.col(r).reshaped(regions, steps), -most_cars, most_cars,
                      what + ", factor " + std::to_string(r), "step");
  }
  complaint.require(set.g1, 0.0, most_threshold, what + ", threshold g1");
  complaint.require(set.g2, 0.0, most_threshold, what + ", threshold g2");
}

void check_transitions(Complaint& complaint, const Transitions& move, const std::string& step) {
  constexpr double rounding = 1e-6;
  const auto stochastic = [&](const Eigen::MatrixXd& sum, const std::string& what) {
    complaint.require(sum.rowwise().sum(), 1.0 - rounding, 1.0 + rounding, what + ", step " + step + ", row sum", "");
  };
  for (const auto* matrix : {&move.vacant_to_vacant, &move.vacant_to_occupied, &move.vacant_to_low_battery,
                             &move.occupied_to_vacant, &move.occupied_to_occupied}) {
    complaint.require(*matrix, 0.0, 1.0 + rounding, "transitions, step " + step, "to");
  }
  stochastic(move.vacant_to_vacant + move.vacant_to_occupied + move.vacant_to_low_battery, "transitions of vacant");
  stochastic(move.occupied_to_vacant + move.occupied_to_occupied, "transitions of occupied");
}

void check_parameters(Complaint& complaint, const BalancingParameters& p) {
  complaint.require(p.a, 1e-3, 10.0, "parameter a");
  complaint.require(p.theta_0, 0.0, most_price, "parameter theta_0");
  complaint.require(p.eps, 1e-3, most_cars, "parameter eps");
  complaint.require(p.beta, 0.0, most_price, "parameter beta");
  complaint.require(p.omega, 0.0, most_price, "parameter omega");
  complaint.require(p.pi_e, 0.0, most_price, "parameter pi_e");
  complaint.require(p.p_shortage, 0.0, most_price, "parameter p_shortage");
  complaint.require(p.p_surplus, 0.0, most_price, "parameter p_surplus");
  complaint.require(p.p_ratio, 0.0, most_price, "parameter p_ratio");
  complaint.require(p.p_flow, 0.0, most_price, "parameter p_flow");
  complaint.require(p.eta, 0.0, 1.0, "parameter eta");
  complaint.require(p.top_up, 0.0, most_price, "parameter top_up");
  complaint.require(p.m1, 0.0, infinity, "parameter m1");
  complaint.require(p.m2, 0.0, infinity, "parameter m2");
  complaint.require(p.flow_end, 0.0, 1.0, "parameter flow_end");
  complaint.require(p.flow_patience, 0.0, most_minutes, "parameter flow_patience");
  complaint.require(p.flow_slot, 1.0, most_minutes, "parameter flow_slot");
  complaint.require(p.flow_m1, 0.0, infinity, "parameter flow_m1");
  complaint.require(p.flow_value, 0.0, 1.0, "parameter flow_value");
}

void check_turnover(Complaint& complaint, const PlanningData& data) {
  const Turnover& turnover = data.turnover;
  complaint.require(turnover.phi, 0.0, 1.0, "phi");
  complaint.require(turnover.same_step_dropoffs, 0.0, 1.0, "trips that end within the step", "to");
  for (const double linear : turnover.demand.linear) {
    complaint.require(linear, 0.0, 100.0, "variance of demand, linear");
  }
  for (const double quadratic : turnover.demand.quadratic) {
    complaint.require(quadratic, 0.0, 100.0, "variance of demand, quadratic");
    const double passengers = std::max(0.0, data.demand.mean.maxCoeff()) + data.state.waiting.maxCoeff();
    complaint.require(quadratic * passengers, 0.0, most_variance, "variance of demand over its mean");
  }
}

void check_freed(Complaint& complaint, const FreedCars& freed) {
  complaint.require(freed.mean, 0.0, most_cars, "vehicles that become vacant", "slot");
  complaint.require(freed.variance, 0.0, most_variance, "variance of vehicles that become vacant", "slot");
}

void check_worth(Complaint& complaint, const CarWorth& worth) {
  complaint.require(worth.vacant, 0.0, most_price, "worth of a vacant vehicle", "");
  complaint.require(worth.serving, 0.0, most_price, "worth of a vehicle that takes a passenger", "");
}

void expect_shapes(const PlanningData& data) {
  const auto n = data.km.rows();
  const auto tau = data.points.cols();
  const auto is = [](const auto& matrix, Eigen::Index rows, Eigen::Index columns) {
    return matrix.rows() == rows && matrix.cols() == columns;
  };
  const auto stacked = [&](const MomentSet& set) {
    return set.mean.size() == n * tau && set.deviation.size() == n * tau && set.factors.rows() == n * tau;
  };
  const auto& state = data.state;
  EVBAL_EXPECT(n > 0 && tau > 0, "at least one region and one step");
  EVBAL_EXPECT(is(data.km, n, n) && is(data.minutes, n, n), "km and minutes N x N");
  EVBAL_EXPECT(is(data.points, n, tau), "points N x tau");
  EVBAL_EXPECT(is(state.vacant, n, 1) && is(state.occupied, n, 1) && is(state.low_battery, n, 1), "vehicles N");
  EVBAL_EXPECT(is(state.chargeable, n, 1), "chargeable vehicles N");
  EVBAL_EXPECT(std::ssize(state.reach) == n &&
                   std::ranges::all_of(state.reach, [](const auto& reach) { return std::ranges::is_sorted(reach); }),
               "reach of N regions, ascending");
  EVBAL_EXPECT(is(state.plugged, n, 1) && is(state.waiting, n, 1), "plugged vehicles and waiting passengers N");
  EVBAL_EXPECT(is(state.arriving_vacant, n, tau) && is(state.arriving_low_battery, n, tau), "arrivals N x tau");
  EVBAL_EXPECT(is(state.dropoffs_due, n, tau), "drop-offs due N x tau");
  EVBAL_EXPECT(stacked(data.demand), "demand N tau");
  EVBAL_EXPECT(stacked(data.completions), "completions N tau");
  EVBAL_EXPECT(stacked(data.free_points), "free points N tau");
  EVBAL_EXPECT(data.demand_samples.rows() == n * tau, "samples of demand N tau");
  EVBAL_EXPECT(is(data.turnover.same_step_dropoffs, n, n), "trips that end within the step N x N");
  EVBAL_EXPECT(data.freed.mean.rows() == n && data.freed.mean.cols() > 0, "vehicles that become vacant N x slots");
  EVBAL_EXPECT(is(data.freed.variance, n, data.freed.mean.cols()), "their variance N x slots");
  EVBAL_EXPECT(data.worth.vacant.size() == 0 || is(data.worth.vacant, n, 1), "worth of a vehicle N, or none");
  EVBAL_EXPECT(data.worth.serving.size() == data.worth.vacant.size(), "as many worths of one that serves");
  EVBAL_EXPECT(!data.turnover.demand.linear.empty() &&
                   data.turnover.demand.linear.size() == data.turnover.demand.quadratic.size(),
               "as many linear as quadratic coefficients of demand's variance, at least one");
  EVBAL_EXPECT(std::ssize(data.transitions) == tau, "transitions of each step");
  for (const auto& move : data.transitions) {
    EVBAL_EXPECT(is(move.vacant_to_vacant, n, n) && is(move.vacant_to_occupied, n, n) &&
                     is(move.vacant_to_low_battery, n, n) && is(move.occupied_to_vacant, n, n) &&
                     is(move.occupied_to_occupied, n, n),
                 "transitions N x N");
  }
}

}  // namespace

std::string validate(const BalancingParameters& parameters, const PlanningData& data) {
  expect_shapes(data);
  Complaint complaint;
  check_parameters(complaint, parameters);
  complaint.require_or_infinite(data.km, most_km, "km");
  complaint.require_or_infinite(data.minutes, most_minutes, "minutes");
  check_state(complaint, data.state);
  complaint.require(data.points, 0.0, most_cars, "points", "step");
  check_set(complaint, data.demand, data.km.rows(), "demand");
  check_set(complaint, data.completions, data.km.rows(), "completions");
  check_set(complaint, data.free_points, data.km.rows(), "free points");
  for (Eigen::Index k = 0; k < data.points.cols(); ++k) {
    complaint.require(data.demand_samples.middleRows(k * data.km.rows(), data.km.rows()), -most_cars, most_cars,
                      "demand, step " + std::to_string(k) + ",", "sample");
  }
  check_turnover(complaint, data);
  check_freed(complaint, data.freed);
  check_worth(complaint, data.worth);
  for (std::size_t k = 0; k < data.transitions.size(); ++k) {
    check_transitions(complaint, data.transitions[k], std::to_string(k));
  }
  complaint.require(data.step_minutes, 1e-3, most_minutes, "step_minutes");
  complaint.require(data.mean_session_minutes, 1e-3, most_minutes, "mean_session_minutes");
  return complaint.text();
}

}  // namespace evbal
