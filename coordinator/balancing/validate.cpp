#include "coordinator/balancing/validate.hpp"

#include <cassert>
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

constexpr double most = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::min();  // above zero
constexpr double most_cars = 1e6;                             // in one region; of passengers too

void check_state(Complaint& complaint, const FleetState& state) {
  complaint.require(state.vacant, 0.0, most_cars, "vacant vehicles", "");
  complaint.require(state.occupied, 0.0, most_cars, "occupied vehicles", "");
  complaint.require(state.low_battery, 0.0, most_cars, "low-battery vehicles", "");
  complaint.require(state.plugged, 0.0, most_cars, "plugged vehicles", "");
  complaint.require(state.waiting, 0.0, most_cars, "waiting passengers", "");
  complaint.require(state.arriving_vacant, 0.0, most_cars, "arriving vacant vehicles", "step");
  complaint.require(state.arriving_low_battery, 0.0, most_cars, "arriving low-battery vehicles", "step");
  complaint.require(state.dropoffs_due, 0.0, most_cars, "drop-offs due", "step");
}

void check_set(Complaint& complaint, const MomentSet& set, Eigen::Index regions, const std::string& what) {
  const auto steps = set.mean.size() / regions;
  complaint.require(set.mean.reshaped(regions, steps), -most_cars, most_cars, what + ", mean", "step");
  complaint.require(set.deviation.reshaped(regions, steps), least, most, what + ", deviation", "step");
  for (Eigen::Index r = 0; r < set.factors.cols(); ++r) {
    complaint.require(set.factors.col(r).reshaped(regions, steps), -most, most, what + ", factor " + std::to_string(r),
                      "step");
  }
  complaint.require(set.g1, 0.0, most, what + ", threshold g1");
  complaint.require(set.g2, 0.0, most, what + ", threshold g2");
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
  complaint.require(p.a, least, most, "parameter a");
  complaint.require(p.theta_0, 0.0, most, "parameter theta_0");
  complaint.require(p.eps, least, most, "parameter eps");
  complaint.require(p.beta, 0.0, most, "parameter beta");
  complaint.require(p.omega, 0.0, most, "parameter omega");
  complaint.require(p.pi_e, 0.0, most, "parameter pi_e");
  complaint.require(p.p_shortage, 0.0, most, "parameter p_shortage");
  complaint.require(p.p_surplus, 0.0, most, "parameter p_surplus");
  complaint.require(p.p_ratio, 0.0, most, "parameter p_ratio");
  complaint.require(p.eta, 0.0, 1.0, "parameter eta");
  complaint.require(p.m1, 0.0, infinity, "parameter m1");
  complaint.require(p.m2, 0.0, infinity, "parameter m2");
}

void check_turnover(Complaint& complaint, const Turnover& turnover) {
  complaint.require(turnover.phi, 0.0, 1.0, "phi");
  complaint.require(turnover.same_step_dropoffs, 0.0, 1.0, "trips that end within the step", "to");
  for (const double linear : turnover.demand.linear) {
    complaint.require(linear, 0.0, 100.0, "variance of demand, linear");
  }
  for (const double quadratic : turnover.demand.quadratic) {
    complaint.require(quadratic, 0.0, 100.0, "variance of demand, quadratic");
  }
}

void assert_shapes([[maybe_unused]] const PlanningData& data) {
  [[maybe_unused]] const auto n = data.km.rows();
  [[maybe_unused]] const auto tau = data.points.cols();
  assert(n > 0 && tau > 0 && data.km.cols() == n && data.points.rows() == n);
  assert(data.minutes.rows() == n && data.minutes.cols() == n);
  assert(data.state.vacant.size() == n && data.state.occupied.size() == n && data.state.low_battery.size() == n);
  assert(data.state.plugged.size() == n && data.state.waiting.size() == n);
  assert(data.state.arriving_vacant.rows() == n && data.state.arriving_vacant.cols() == tau);
  assert(data.state.arriving_low_battery.rows() == n && data.state.arriving_low_battery.cols() == tau);
  assert(data.demand.mean.size() == n * tau && data.demand.deviation.size() == n * tau);
  assert(data.demand.factors.rows() == n * tau && data.completions.factors.rows() == n * tau);
  assert(data.completions.mean.size() == n * tau && data.completions.deviation.size() == n * tau);
  assert(data.free_points.mean.size() == n * tau && data.free_points.deviation.size() == n * tau);
  assert(data.free_points.factors.rows() == n * tau);
  assert(data.demand_samples.rows() == n * tau);
  assert(data.state.dropoffs_due.rows() == n && data.state.dropoffs_due.cols() == tau);
  assert(data.turnover.same_step_dropoffs.rows() == n && data.turnover.same_step_dropoffs.cols() == n);
  assert(!data.turnover.demand.linear.empty());
  assert(data.turnover.demand.linear.size() == data.turnover.demand.quadratic.size());
  assert(std::ssize(data.transitions) == tau);
}

}  // namespace

std::string complaint(const BalancingParameters& parameters, const PlanningData& data) {
  assert_shapes(data);
  Complaint complaint;
  check_parameters(complaint, parameters);
  complaint.require(data.km, 0.0, infinity, "km", "to");
  complaint.require(data.minutes, 0.0, infinity, "minutes", "to");
  check_state(complaint, data.state);
  complaint.require(data.points, 0.0, most_cars, "points", "step");
  check_set(complaint, data.demand, data.km.rows(), "demand");
  check_set(complaint, data.completions, data.km.rows(), "completions");
  check_set(complaint, data.free_points, data.km.rows(), "free points");
  for (Eigen::Index k = 0; k < data.points.cols(); ++k) {
    complaint.require(data.demand_samples.middleRows(k * data.km.rows(), data.km.rows()), -most_cars, most_cars,
                      "demand, step " + std::to_string(k) + ",", "sample");
  }
  check_turnover(complaint, data.turnover);
  for (std::size_t k = 0; k < data.transitions.size(); ++k) {
    check_transitions(complaint, data.transitions[k], std::to_string(k));
  }
  complaint.require(data.step_minutes, least, most, "step_minutes");
  complaint.require(data.mean_session_minutes, least, most, "mean_session_minutes");
  return complaint.text();
}

}  // namespace evbal
