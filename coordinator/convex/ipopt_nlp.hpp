#pragma once

#include "common/eigen.hpp"
#include "coordinator/convex/convex_program.hpp"

#include <IpTNLP.hpp>

#include <vector>

namespace evbal {

/// A ConvexProgram as Ipopt wants it, with exact sparse derivatives. Every norm becomes
///
///     || Sigma^(1/2) Z || = min over t > 0 of (t + (Z' D^2 Z + f'f) / t) / 2,     f = F'Z,     Sigma = D^2 + F F',
///
/// whose Hessian is an arrow instead of a full block (docs/model.md, section 6). Variables: the program's, then for
/// every norm t and f. Rows: the program's, then f - F'Z = 0, then function(of) - above <= 0.
class IpoptNlp final : public Ipopt::TNLP {
 public:
  /// Ipopt's.
  using Index = Ipopt::Index;
  /// Ipopt's.
  using Number = Ipopt::Number;

  /// `program` must outlive this.
  explicit IpoptNlp(const ConvexProgram& program);

  /// The point at which Ipopt stopped, in the program's variables.
  const Eigen::VectorXd& point() const { return point_; }

  /// Sizes, as Ipopt::TNLP asks for them.
  bool get_nlp_info(Index& n, Index& m, Index& nnz_jacobian, Index& nnz_hessian, IndexStyleEnum& style) override;
  /// Bounds of variables and rows.
  bool get_bounds_info(Index n, Number* lower, Number* upper, Index m, Number* row_low, Number* row_high) override;
  /// A point within the bounds.
  bool get_starting_point(Index n, bool init_x, Number* x, bool init_z, Number* z_lower, Number* z_upper, Index m,
                          bool init_lambda, Number* lambda) override;
  /// The objective.
  bool eval_f(Index n, const Number* x, bool new_x, Number& value) override;
  /// Its gradient.
  bool eval_grad_f(Index n, const Number* x, bool new_x, Number* gradient) override;
  /// The rows.
  bool eval_g(Index n, const Number* x, bool new_x, Index m, Number* rows) override;
  /// Their Jacobian.
  bool eval_jac_g(Index n, const Number* x, bool new_x, Index m, Index nnz, Index* row, Index* column,
                  Number* values) override;
  /// The Hessian of the Lagrangian.
  bool eval_h(Index n, const Number* x, bool new_x, Number objective_factor, Index m, const Number* lambda,
              bool new_lambda, Index nnz, Index* row, Index* column, Number* values) override;
  /// Keeps the point that Ipopt ends with.
  void finalize_solution(Ipopt::SolverReturn status, Index n, const Number* x, const Number* z_lower,
                         const Number* z_upper, Index m, const Number* rows, const Number* lambda, Number value,
                         const Ipopt::IpoptData* data, Ipopt::IpoptCalculatedQuantities* quantities) override;

 private:
  // A norm with the places of its extra variables and rows.
  struct Lifted {
    const NormTerm* norm = nullptr;
    int t = 0;
    int f = 0;    // first of rank
    int row = 0;  // first of rank: f - F'Z = 0
  };

  double squared(const Lifted& lifted, const Number* x) const;

  // Around x, or around the nearest bound of its variable where Ipopt oversteps that by its tolerance.
  ConvexFunction::Expansion around(const CurveRow& curve, const Number* x) const;

  const ConvexProgram& program_;
  std::vector<Lifted> norms_;
  int variables_ = 0;
  int first_curve_row_ = 0;
  Eigen::VectorXd point_;
};

}  // namespace evbal
