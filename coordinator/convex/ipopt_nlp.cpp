#include "coordinator/convex/ipopt_nlp.hpp"

#include <algorithm>

namespace evbal {
namespace {

// Ipopt takes anything beyond 1e19 as no bound.
double finite(double bound) {
  constexpr double no_bound = 1e20;
  return std::clamp(bound, -no_bound, no_bound);
}

// Writes the entries of a sparse matrix: first their places, later their values, always in the same order.
class Triplets {
 public:
  Triplets(Ipopt::Index* row, Ipopt::Index* column, Ipopt::Number* values)
      : row_(row), column_(column), values_(values) {}

  bool wants_values() const { return values_ != nullptr; }

  void place(int row, int column) {
    row_[next_] = row;
    column_[next_++] = column;
  }

  void value(double value) { values_[next_++] = value; }

 private:
  Ipopt::Index* row_;
  Ipopt::Index* column_;
  Ipopt::Number* values_;
  std::ptrdiff_t next_ = 0;
};

}  // namespace

IpoptNlp::IpoptNlp(const ConvexProgram& program)
    : program_(program), variables_(program.variables()), first_curve_row_(program.rows()) {
  for (const auto& norm : program.norms()) {
    const int rank = static_cast<int>(norm.factors.cols());
    norms_.push_back({&norm, variables_, variables_ + 1, first_curve_row_});
    variables_ += 1 + rank;
    first_curve_row_ += rank;
  }
}

bool IpoptNlp::get_nlp_info(Index& n, Index& m, Index& nnz_jacobian, Index& nnz_hessian, IndexStyleEnum& style) {
  const auto curves = static_cast<int>(program_.curves().size());
  n = variables_;
  m = first_curve_row_ + curves;
  nnz_jacobian = static_cast<int>(program_.entries().size()) + 2 * curves;
  nnz_hessian = curves;
  for (const auto& lifted : norms_) {
    const auto size = static_cast<int>(lifted.norm->variables.size());
    const auto rank = static_cast<int>(lifted.norm->factors.cols());
    nnz_jacobian += rank * (size + 1);
    nnz_hessian += 2 * (size + rank) + 1;
  }
  style = C_STYLE;
  return true;
}

bool IpoptNlp::get_bounds_info(Index n, Number* lower, Number* upper, Index m, Number* row_low, Number* row_high) {
  std::ranges::transform(program_.lower(), lower, finite);
  std::ranges::transform(program_.upper(), upper, finite);
  std::ranges::transform(program_.row_low(), row_low, finite);
  std::ranges::transform(program_.row_high(), row_high, finite);
  std::fill(lower + program_.variables(), lower + n, finite(-ConvexProgram::infinity));
  std::fill(upper + program_.variables(), upper + n, finite(ConvexProgram::infinity));
  for (const auto& lifted : norms_) {
    lower[lifted.t] = 0.0;
  }
  std::fill(row_low + program_.rows(), row_low + first_curve_row_, 0.0);
  std::fill(row_high + program_.rows(), row_high + first_curve_row_, 0.0);
  std::fill(row_low + first_curve_row_, row_low + m, finite(-ConvexProgram::infinity));
  std::fill(row_high + first_curve_row_, row_high + m, 0.0);
  return true;
}

bool IpoptNlp::get_starting_point(Index n, bool /*init_x*/, Number* x, bool /*init_z*/, Number* /*z_lower*/,
                                  Number* /*z_upper*/, Index /*m*/, bool /*init_lambda*/, Number* /*lambda*/) {
  std::fill(x, x + n, 0.0);
  for (int i = 0; i < program_.variables(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    x[i] = std::clamp(0.0, program_.lower()[at], program_.upper()[at]);
  }
  for (const auto& curve : program_.curves()) {
    x[curve.above] = std::max(x[curve.above], around(curve, x).value);
  }
  for (const auto& [norm, t, f, row] : norms_) {
    const Eigen::VectorXd z = values_of(norm->variables, Eigen::Map<const Eigen::VectorXd>(x, n));
    x[t] = std::max(norm->norm(z), 1.0);
    Eigen::Map<Eigen::VectorXd>(x + f, norm->factors.cols()) = norm->factors.transpose() * z;
  }
  return true;
}

double IpoptNlp::squared(const Lifted& lifted, const Number* x) const {
  const auto& norm = *lifted.norm;
  double sum = Eigen::Map<const Eigen::VectorXd>(x + lifted.f, norm.factors.cols()).squaredNorm();
  for (std::size_t i = 0; i < norm.variables.size(); ++i) {
    const double scaled = norm.deviation(static_cast<Eigen::Index>(i)) * x[norm.variables[i]];
    sum += scaled * scaled;
  }
  return sum;
}

ConvexFunction::Expansion IpoptNlp::around(const CurveRow& curve, const Number* x) const {
  const auto of = static_cast<std::size_t>(curve.of);
  return curve.function->around(std::clamp(x[curve.of], program_.lower()[of], program_.upper()[of]));
}

bool IpoptNlp::eval_f(Index /*n*/, const Number* x, bool /*new_x*/, Number& value) {
  value = program_.constant();
  for (int i = 0; i < program_.variables(); ++i) {
    value += program_.cost()[static_cast<std::size_t>(i)] * x[i];
  }
  for (const auto& lifted : norms_) {
    value += 0.5 * lifted.norm->weight * (x[lifted.t] + squared(lifted, x) / x[lifted.t]);
  }
  return true;
}

bool IpoptNlp::eval_grad_f(Index n, const Number* x, bool /*new_x*/, Number* gradient) {
  std::fill(std::ranges::copy(program_.cost(), gradient).out, gradient + n, 0.0);
  for (const auto& lifted : norms_) {
    const auto& norm = *lifted.norm;
    const double t = x[lifted.t];
    for (std::size_t i = 0; i < norm.variables.size(); ++i) {
      const double deviation = norm.deviation(static_cast<Eigen::Index>(i));
      gradient[norm.variables[i]] += norm.weight * deviation * deviation * x[norm.variables[i]] / t;
    }
    for (int r = 0; r < norm.factors.cols(); ++r) {
      gradient[lifted.f + r] = norm.weight * x[lifted.f + r] / t;
    }
    gradient[lifted.t] = 0.5 * norm.weight * (1.0 - squared(lifted, x) / (t * t));
  }
  return true;
}

bool IpoptNlp::eval_g(Index n, const Number* x, bool /*new_x*/, Index /*m*/, Number* rows) {
  for (int row = 0; row < program_.rows(); ++row) {
    rows[row] = 0.0;
    const auto* start = program_.row_start().data() + row;
    for (int at = start[0]; at < start[1]; ++at) {
      const auto& [variable, coefficient] = program_.entries()[static_cast<std::size_t>(at)];
      rows[row] += coefficient * x[variable];
    }
  }
  for (const auto& [norm, t, f, row] : norms_) {
    const auto rank = norm->factors.cols();
    const Eigen::VectorXd z = values_of(norm->variables, Eigen::Map<const Eigen::VectorXd>(x, n));
    Eigen::Map<Eigen::VectorXd>(rows + row, rank) =
        Eigen::Map<const Eigen::VectorXd>(x + f, rank) - norm->factors.transpose() * z;
  }
  int row = first_curve_row_;
  for (const auto& curve : program_.curves()) {
    rows[row++] = around(curve, x).value - x[curve.above];
  }
  return true;
}

bool IpoptNlp::eval_jac_g(Index /*n*/, const Number* x, bool /*new_x*/, Index /*m*/, Index /*nnz*/, Index* row,
                          Index* column, Number* values) {
  Triplets triplets(row, column, values);
  const auto put = [&triplets](int at_row, int at_column, double value) {
    triplets.wants_values() ? triplets.value(value) : triplets.place(at_row, at_column);
  };
  for (int r = 0; r < program_.rows(); ++r) {
    const auto* start = program_.row_start().data() + r;
    for (int at = start[0]; at < start[1]; ++at) {
      const auto& [variable, coefficient] = program_.entries()[static_cast<std::size_t>(at)];
      put(r, variable, coefficient);
    }
  }
  for (const auto& [norm, t, f, first_row] : norms_) {
    for (int r = 0; r < norm->factors.cols(); ++r) {
      put(first_row + r, f + r, 1.0);
      for (std::size_t i = 0; i < norm->variables.size(); ++i) {
        put(first_row + r, norm->variables[i], -norm->factors(static_cast<Eigen::Index>(i), r));
      }
    }
  }
  int at_row = first_curve_row_;
  for (const auto& curve : program_.curves()) {
    put(at_row, curve.of, triplets.wants_values() ? around(curve, x).slope : 0.0);
    put(at_row++, curve.above, -1.0);
  }
  return true;
}

bool IpoptNlp::eval_h(Index /*n*/, const Number* x, bool /*new_x*/, Number objective_factor, Index /*m*/,
                      const Number* lambda, bool /*new_lambda*/, Index /*nnz*/, Index* row, Index* column,
                      Number* values) {
  Triplets triplets(row, column, values);
  if (!triplets.wants_values()) {
    for (const auto& [norm, t, f, first_row] : norms_) {
      for (const int variable : norm->variables) {
        triplets.place(variable, variable);
        triplets.place(t, variable);
      }
      for (int r = 0; r < norm->factors.cols(); ++r) {
        triplets.place(f + r, f + r);
        triplets.place(f + r, t);
      }
      triplets.place(t, t);
    }
    for (const auto& curve : program_.curves()) {
      triplets.place(curve.of, curve.of);
    }
    return true;
  }
  for (const auto& lifted : norms_) {
    const auto& norm = *lifted.norm;
    const double t = x[lifted.t];
    const double scale = objective_factor * norm.weight / t;
    for (std::size_t i = 0; i < norm.variables.size(); ++i) {
      const double deviation = norm.deviation(static_cast<Eigen::Index>(i));
      triplets.value(scale * deviation * deviation);
      triplets.value(-scale * deviation * deviation * x[norm.variables[i]] / t);
    }
    for (int r = 0; r < norm.factors.cols(); ++r) {
      triplets.value(scale);
      triplets.value(-scale * x[lifted.f + r] / t);
    }
    triplets.value(scale * squared(lifted, x) / (t * t));
  }
  const Number* multiplier = lambda + first_curve_row_;
  for (const auto& curve : program_.curves()) {
    triplets.value(*multiplier++ * around(curve, x).curvature);
  }
  return true;
}

void IpoptNlp::finalize_solution(Ipopt::SolverReturn /*status*/, Index /*n*/, const Number* x,
                                 const Number* /*z_lower*/, const Number* /*z_upper*/, Index /*m*/,
                                 const Number* /*rows*/, const Number* /*lambda*/, Number /*value*/,
                                 const Ipopt::IpoptData* /*data*/, Ipopt::IpoptCalculatedQuantities* /*quantities*/) {
  point_ = Eigen::Map<const Eigen::VectorXd>(x, program_.variables());
}

}  // namespace evbal
