#pragma once

#include "common/eigen.hpp"
#include "coordinator/convex/convex_program.hpp"
#include "coordinator/convex/linear_program.hpp"
#include "coordinator/convex/start.hpp"
#include "coordinator/convex/tangents.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// A ConvexProgram with its curves and norms known only through tangents: a linear program (COIN-OR Clp) whose optimum
/// is a lower bound of the program's, since a convex function lies above its tangents.
///
/// The largest of a curve's tangents is made of straight pieces, one a tangent, whose slopes rise:
///
///     of    = lower + sum of parts,         0 <= part_m <= width_m
///     above = height + value at lower + sum of slope_m part_m,         height >= 0
///
/// `above` is written out so wherever it occurs. A tangent is thus a bounded column, which the simplex method passes
/// without a pivot, and not a row: many cost little more than a few. A norm is the height over its first tangent, which
/// goes into the cost; each further tangent is a row.
class LinearRelaxation {
 public:
  /// Starts with tangents of each curve ever further apart from its lower end, where it bends most, and around where
  /// `start` was, and with one of each norm; from the basis of `start`, if it has one. `program` must outlive this, and
  /// has no other bound on what stands above a curve than the curve.
  explicit LinearRelaxation(const ConvexProgram& program, const Start& start = {});

  /// What a solve came to.
  struct Outcome {
    std::string why_not;       ///< there is no optimum, empty if there is
    double lower_bound = 0.0;  ///< of the program's optimum
    Eigen::VectorXd x;         ///< in the program's variables
  };

  /// Solves the linear program of the tangents so far by the dual method: the first time from the start that was given,
  /// or from a basis that needs no prices (dual values); then from the prices of the last optimum, which stay dual
  /// feasible when tangents are added. Starts afresh where that does not soon lead to an optimum.
  Outcome solve();

  /// Where the last solve ended; before the first, what is known of the start that was given.
  Start start() const;

  /// Makes the tangents of each curve denser around the slope that the prices of the last optimum ask of it, and adds
  /// those of all curves and norms at `x`.
  void refine(const Eigen::VectorXd& x);

 private:
  struct Curve {
    const CurveRow* row = nullptr;
    Tangents tangents;
    std::vector<Tangents::Piece> pieces = {};  // as they were solved last
    int first_part = 0;                        // column
    std::optional<CurveStart> start = {};      // where the last solve ended
  };

  /// Where a column stands in a basis. Rows are basic, where they do not bind, or at one of their sides.
  enum class Place : unsigned char { lower, upper, basic };

  struct NormRow {
    std::size_t norm = 0;
    Eigen::VectorXd over_first;  // its gradient less that of the first tangent
  };

  LinearProgram linear_program();
  void add_columns(LinearProgram& lp);
  double write(LinearProgram& lp, int variable, double coefficient) const;
  void start_without_prices(ClpSimplex& clp) const;
  const Expression::Term* defined_by(const ClpSimplex& clp, int row) const;
  const Expression::Term* held_back(const ClpSimplex& clp, int row, const std::vector<double>& reduced) const;
  std::shared_ptr<ClpSimplex> solved_from_prices(const LinearProgram& lp) const;
  void start_from_prices(ClpSimplex& clp) const;
  void start_from_prices(ClpSimplex& clp, const Curve& curve) const;
  void remember(const ClpSimplex& clp);
  CurveStart end_of(const ClpSimplex& clp, int curve) const;
  void name_columns_and_rows();
  void place(const Start& start);
  std::uint64_t key_of_row(int row) const;
  Eigen::VectorXd point(const ClpSimplex& clp) const;
  int first_part() const { return program_.variables() + static_cast<int>(first_gradients_.size()); }

  const ConvexProgram& program_;
  std::vector<Curve> curves_;
  std::vector<int> curve_above_;                  // by variable: the curve that it stands above, or -1
  std::vector<bool> has_curve_;                   // by variable: whether a curve is of it
  std::vector<Eigen::VectorXd> first_gradients_;  // of the norms
  std::vector<NormRow> norm_rows_;
  std::vector<std::uint64_t> column_keys_;  // of program and norms
  std::vector<std::uint64_t> row_keys_;     // of program and curves
  std::vector<Place> columns_;              // where the last solve ended, of program and norms; empty: not known
  std::vector<bool> binding_;               // rows that hold as equations there
};

}  // namespace evbal
