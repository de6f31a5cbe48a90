#include "coordinator/convex/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace evbal {
namespace {

// "supply[3], step 1: violated by 0.4 vehicles"
std::string violated(const Violation& violation) {
  std::ostringstream text;
  text << violation.where << ": ";
  if (std::isinf(violation.amount)) {
    text << "not a finite number";
  } else {
    text << "violated by " << violation.amount << (violation.unit.empty() ? "" : " ") << violation.unit;
  }
  return text.str();
}

}  // namespace

Certificate certify(const ConvexProgram& program, const Eigen::VectorXd& x, double lower_bound) {
  const Violation violation = program.violation(x);
  Certificate certificate;
  certificate.objective = program.objective(x);
  certificate.lower_bound = lower_bound;
  const double scale = std::max(1.0, std::abs(certificate.objective - program.penalty(x)));
  certificate.gap = (certificate.objective - lower_bound) / scale;
  certificate.max_violation = violation.amount;
  std::ostringstream reason;
  if (violation.amount > optimality_tolerance) {
    certificate.status = SolveStatus::infeasible;
    reason << violated(violation);
  } else if (certificate.gap < -optimality_tolerance) {
    certificate.status = SolveStatus::below_bound;
    reason << "the objective is below its lower bound: the relative gap is " << certificate.gap;
  } else if (certificate.gap <= optimality_tolerance) {
    certificate.status = SolveStatus::optimal;
  } else {
    certificate.status = SolveStatus::gap_open;
    reason << "the relative gap to the lower bound is " << certificate.gap;
  }
  certificate.reason = reason.str();
  return certificate;
}

Certificate refusal(const std::string& reason, SolveStatus status) {
  Certificate certificate;
  certificate.status = status;
  certificate.reason = reason;
  certificate.lower_bound = -ConvexProgram::infinity;
  certificate.gap = ConvexProgram::infinity;
  return certificate;
}

Eigen::VectorXd cleaned(const ConvexProgram& program, Eigen::VectorXd x) {
  const auto size = static_cast<Eigen::Index>(program.variables());
  x = x.cwiseMax(Eigen::Map<const Eigen::VectorXd>(program.lower().data(), size))
          .cwiseMin(Eigen::Map<const Eigen::VectorXd>(program.upper().data(), size));
  for (const auto& curve : program.curves()) {
    x(curve.above) = std::max(x(curve.above), curve.function->around(x(curve.of)).value);
  }
  return x;
}

}  // namespace evbal
