#include "coordinator/convex/linear_relaxation.hpp"

#include "common/contract.hpp"

#include <ClpSimplex.hpp>

#include <algorithm>
#include <memory>
#include <utility>

namespace evbal {
namespace {

constexpr double infinity = ConvexProgram::infinity;

// A tangent of a norm at x, scaled down until no variable's cost becomes negative, which could make the linear program
// unbounded. A norm lies above a scaled-down tangent too.
Eigen::VectorXd affordable_gradient(const ConvexProgram& program, const NormTerm& norm, const Eigen::VectorXd& x) {
  const Eigen::VectorXd gradient = norm.gradient(values_of(norm.variables, x));
  double share = 1.0;
  for (std::size_t i = 0; i < norm.variables.size(); ++i) {
    const double cost = std::max(0.0, program.cost()[static_cast<std::size_t>(norm.variables[i])]);
    const double change = norm.weight * gradient(static_cast<Eigen::Index>(i));
    share = cost + change < 0.0 ? std::min(share, -cost / change) : share;
  }
  return share * gradient;
}

}  // namespace

// Columns: the program's, a height for each norm, then each curve's parts. Rows: the program's, one for each curve's
// argument, then the norms' further tangents. So all but the parts keep their place from solve to solve.
LinearRelaxation::LinearRelaxation(const ConvexProgram& program, const Start& start) : program_(program) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(program.variables());
  curve_above_.assign(program.cost().size(), -1);
  has_curve_.assign(program.cost().size(), false);
  name_columns_and_rows();
  for (const auto& curve : program.curves()) {
    int& above = curve_above_[static_cast<std::size_t>(curve.above)];
    EVBAL_EXPECT(above < 0, "a variable above one curve at most");
    above = static_cast<int>(curves_.size());
    has_curve_[static_cast<std::size_t>(curve.of)] = true;
    const double lower = program.lower()[static_cast<std::size_t>(curve.of)];
    const double upper = program.upper()[static_cast<std::size_t>(curve.of)];
    auto& tangents = curves_.emplace_back(Curve{&curve, Tangents(curve.function, lower, upper)}).tangents;
    double at = std::min(lower + 1.0, upper);
    if (const CurveStart* known = start.of_curve(column_keys_[static_cast<std::size_t>(curve.above)])) {
      curves_.back().start = *known;
      at = std::clamp(known->at, lower, upper);
      tangents.add_around(known->slope);
      for (const double touch : known->basic) {
        tangents.add(std::clamp(touch, lower, upper));
      }
    }
    x(curve.above) = curve.function->around(at).value;
  }
  for (const auto& norm : program.norms()) {
    first_gradients_.push_back(affordable_gradient(program, norm, x));
  }
  place(start);
}

LinearProgram LinearRelaxation::linear_program() {
  LinearProgram lp(program_);
  add_columns(lp);
  for (std::size_t row = 0; row + 1 < program_.row_start().size(); ++row) {
    double constant = 0.0;
    for (int at = program_.row_start()[row]; at < program_.row_start()[row + 1]; ++at) {
      const auto& [variable, coefficient] = program_.entries()[static_cast<std::size_t>(at)];
      constant += write(lp, variable, coefficient);
    }
    lp.end_row(program_.row_low()[row] - constant, program_.row_high()[row] - constant);
  }
  for (const auto& curve : curves_) {
    const double lower = program_.lower()[static_cast<std::size_t>(curve.row->of)];
    lp.add(curve.row->of, 1.0);
    for (std::size_t m = 0; m < curve.pieces.size(); ++m) {
      lp.add(curve.first_part + static_cast<int>(m), -1.0);
    }
    lp.end_row(lower, lower);
  }
  for (const auto& [n, gradient] : norm_rows_) {
    double constant = 0.0;
    const auto& variables = program_.norms()[n].variables;
    for (std::size_t i = 0; i < variables.size(); ++i) {
      constant += write(lp, variables[i], -gradient(static_cast<Eigen::Index>(i)));
    }
    lp.add(program_.variables() + static_cast<int>(n), 1.0);
    lp.end_row(-constant);
  }
  return lp;
}

void LinearRelaxation::add_columns(LinearProgram& lp) {
  for (std::size_t n = 0; n < first_gradients_.size(); ++n) {
    const auto& norm = program_.norms()[n];
    lp.add_column(0.0, infinity, norm.weight);
    for (std::size_t i = 0; i < norm.variables.size(); ++i) {
      lp.add_cost(norm.variables[i], norm.weight * first_gradients_[n](static_cast<Eigen::Index>(i)));
    }
  }
  for (auto& curve : curves_) {
    const double cost = lp.cost(curve.row->above);
    lp.bound(curve.row->above, 0.0, infinity);
    lp.add_constant(cost * curve.tangents.value_at_lower());
    curve.first_part = lp.columns();
    curve.pieces = curve.tangents.pieces();
    for (const auto& piece : curve.pieces) {
      lp.add_column(0.0, piece.width, cost * piece.slope);
    }
  }
}

// Writes coefficient * variable, with what stands above a curve in terms of its parts; gives the constant that remains.
double LinearRelaxation::write(LinearProgram& lp, int variable, double coefficient) const {
  lp.add(variable, coefficient);
  const int above = curve_above_[static_cast<std::size_t>(variable)];
  if (above < 0) {
    return 0.0;
  }
  const auto& curve = curves_[static_cast<std::size_t>(above)];
  for (std::size_t m = 0; m < curve.pieces.size(); ++m) {
    lp.add(curve.first_part + static_cast<int>(m), coefficient * curve.pieces[m].slope);
  }
  return coefficient * curve.tangents.value_at_lower();
}

LinearRelaxation::Outcome LinearRelaxation::solve() {
  const LinearProgram lp = linear_program();
  if (const std::string why_not = lp.unfit(); !why_not.empty()) {
    return {.why_not = why_not, .lower_bound = -infinity, .x = {}};
  }
  std::shared_ptr<ClpSimplex> clp = columns_.empty() ? nullptr : solved_from_prices(lp);
  if (clp == nullptr) {
    clp = lp.load();
    start_without_prices(*clp);
    clp->dual();
  }
  if (!clp->isProvenOptimal()) {
    return {.why_not = "Clp finds no optimum", .lower_bound = -infinity, .x = {}};
  }
  remember(*clp);
  return {.why_not = "", .lower_bound = lp.lower_bound(*clp), .x = point(*clp)};
}

Eigen::VectorXd LinearRelaxation::point(const ClpSimplex& clp) const {
  const double* columns = clp.primalColumnSolution();
  Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(columns, program_.variables());
  for (const auto& curve : curves_) {
    double& above = x(curve.row->above);
    above += curve.tangents.value_at_lower();
    for (std::size_t m = 0; m < curve.pieces.size(); ++m) {
      above += curve.pieces[m].slope * columns[curve.first_part + static_cast<int>(m)];
    }
  }
  return x;
}

void LinearRelaxation::refine(const Eigen::VectorXd& x) {
  for (auto& curve : curves_) {
    if (curve.start) {
      curve.tangents.add_around(curve.start->slope);
    }
    curve.tangents.add(x(curve.row->of));
  }
  for (std::size_t n = 0; n < first_gradients_.size(); ++n) {
    const auto& norm = program_.norms()[n];
    norm_rows_.push_back({n, norm.gradient(values_of(norm.variables, x)) - first_gradients_[n]});
  }
}

}  // namespace evbal
