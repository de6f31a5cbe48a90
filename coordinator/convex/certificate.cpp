#include "coordinator/convex/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace evbal {

Certificate certify(const ConvexProgram& program, const Eigen::VectorXd& x, double lower_bound) {
  Certificate certificate;
  certificate.objective = program.objective(x);
  certificate.lower_bound = lower_bound;
  const double scale = std::max(1.0, std::abs(certificate.objective - program.penalty(x)));
  certificate.gap = (certificate.objective - lower_bound) / scale;
  certificate.max_violation = program.violation(x);
  std::ostringstream complaint;
  if (!(certificate.max_violation <= optimality_tolerance)) {
    complaint << "a constraint is violated by " << certificate.max_violation;
  } else if (!(certificate.gap <= optimality_tolerance)) {
    complaint << "the relative gap to the lower bound is " << certificate.gap;
  }
  certificate.why_not = complaint.str();
  certificate.optimal = certificate.why_not.empty();
  return certificate;
}

Certificate refusal(const std::string& why_not) {
  Certificate certificate;
  certificate.why_not = why_not;
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
