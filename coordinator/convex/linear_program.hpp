#pragma once

#include "coordinator/convex/convex_program.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class ClpSimplex;

namespace evbal {

/// A linear program on its way to Clp:  min constant + cost'x  s.t.  low <= A x <= high,  lower <= x <= upper.
class LinearProgram {
 public:
  /// Starts with the columns of `program`; its rows, curves and norms are left to the caller.
  explicit LinearProgram(const ConvexProgram& program);

  /// A further column, by its position.
  int add_column(double lower, double upper, double cost);

  /// Sets the bounds of a column.
  void bound(int column, double lower, double upper);
  /// Adds to a column's cost.
  void add_cost(int column, double cost) { cost_[static_cast<std::size_t>(column)] += cost; }
  /// Adds to the objective's constant.
  void add_constant(double cost) { constant_ += cost; }
  /// Of a column.
  double cost(int column) const { return cost_[static_cast<std::size_t>(column)]; }

  /// Adds to the row that is being written; end_row() ends it.
  void add(int column, double coefficient);
  /// Ends the row of the entries added since the last one.
  void end_row(double low, double high = ConvexProgram::infinity);

  /// Number of columns.
  int columns() const { return static_cast<int>(cost_.size()); }
  /// Number of rows.
  int rows() const { return static_cast<int>(row_low_.size()); }

  /// Names of columns or rows for messages, by index.
  using Names = std::function<std::string(int)>;

  /// Why Clp may not be given this program: names the first number that is not finite or beyond `largest_number`, on
  /// which Clp ends the process; empty if there is none. Bounds and sides of rows may be infinite where they bind
  /// nothing.
  std::string unfit(const Names& column, const Names& row) const;
  /// The same, with columns and rows by their number.
  std::string unfit() const;

  /// This program in Clp, not solved yet; it is fit.
  std::shared_ptr<ClpSimplex> load() const;

  /// The rows' multipliers at the optimum: by how much the objective rises with each unit of a row's sides. By an
  /// interior point method, which ends amid those that are right if there are several. None if there is no optimum.
  std::optional<Eigen::VectorXd> multipliers() const;

  /// A lower bound of the optimum from the multipliers that Clp ended with: safe against the tolerances of the simplex
  /// method.
  double lower_bound(const ClpSimplex& solved) const;

 private:
  double constant_ = 0.0;
  std::vector<double> lower_;
  std::vector<double> upper_;
  std::vector<double> cost_;
  std::vector<int> row_start_ = {0};
  std::vector<int> entry_column_;
  std::vector<double> entry_;
  std::vector<double> row_low_;
  std::vector<double> row_high_;
};

/// The largest number that an engine is given. Clp takes 1e25 and more for a mistake of its caller and aborts.
inline constexpr double largest_number = 1e20;

/// Whether a number is finite and within `largest_number`.
bool is_fit(double number);

/// The columns and rows of `program`, without its curves and norms.
LinearProgram linear_part(const ConvexProgram& program);

/// Simplex iterations of one linear program; the largest city needs a tenth.
inline constexpr int max_simplex_iterations = 1000000;

}  // namespace evbal
