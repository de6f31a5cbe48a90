#include "tools/verify/inner_problem.hpp"

#include "coordinator/ambiguity/covariance.hpp"
#include "coordinator/convex/convex_program.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <vector>

namespace evbal {
namespace {

// min objective'y  s.t.  sum_i y_i F_i - F_0 >= 0  block by block; entries (i, block, row, column, value), all from 1
// except i, upper triangles only.
class SemidefiniteProgram {
 public:
  explicit SemidefiniteProgram(std::vector<int> blocks) : blocks_(std::move(blocks)) {}

  // A new variable, by its number from 1.
  int variable(double cost) {
    costs_.push_back(cost);
    return static_cast<int>(costs_.size());
  }

  // Adds `value` times the variable at a place of a block; variable 0 stands for minus the constant.
  void entry(int variable, int block, Eigen::Index row, Eigen::Index column, double value) {
    assert(row <= column);
    if (value != 0.0) {
      std::array<char, 96> line{};
      std::snprintf(line.data(), line.size(), "%d %d %td %td %.17g\n", variable, block, row + 1, column + 1, value);
      entries_ += line.data();
    }
  }

  std::string text() const {
    std::string out = std::to_string(costs_.size()) + "\n" + std::to_string(blocks_.size()) + "\n";
    for (const int size : blocks_) {
      out += std::to_string(size) + " ";
    }
    out += "\n";
    for (const double cost : costs_) {
      out += std::to_string(cost) + " ";
    }
    return out + "\n" + entries_;
  }

 private:
  std::vector<int> blocks_;
  std::vector<double> costs_;
  std::string entries_;
};

}  // namespace

std::string inner_problem(const MomentSet& set, const Eigen::VectorXd& h) {
  const Eigen::Index size = h.size();
  const Eigen::VectorXd& mean = set.mean;
  const Eigen::MatrixXd covariance = Covariance{set.deviation, set.factors}.dense();
  const Eigen::MatrixXd root = std::sqrt(set.g1) * Eigen::MatrixXd(covariance.llt().matrixU());  // root'root = g1 Sigma
  const Eigen::MatrixXd second_moment = set.g2 * covariance + mean * mean.transpose();
  constexpr int schur = 1;
  constexpr int cone = 2;  // s >= || w ||  as  [ s w' ; w s I ] >= 0
  const int side = static_cast<int>(size) + 1;
  SemidefiniteProgram sdp({side, side});

  const auto into_s = [&](int variable, double value) {
    for (Eigen::Index i = 0; i <= size; ++i) {
      sdp.entry(variable, cone, i, i, value);
    }
  };
  const auto into_w = [&](int variable, const Eigen::VectorXd& value) {
    for (Eigen::Index i = 0; i < size; ++i) {
      sdp.entry(variable, cone, 0, i + 1, value(i));
    }
  };

  const int v = sdp.variable(1.0);
  sdp.entry(v, schur, 0, 0, 1.0);
  const int t = sdp.variable(1.0);
  into_s(t, 1.0);
  for (Eigen::Index i = 0; i < size; ++i) {
    const int q = sdp.variable(0.0);
    sdp.entry(q, schur, 0, i + 1, 0.5);
    sdp.entry(0, schur, 0, i + 1, 0.5 * h(i));
    into_s(q, -mean(i));
    into_w(q, root.col(i));
  }
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = i; j < size; ++j) {
      const int Q = sdp.variable(0.0);
      const double twice = i == j ? 1.0 : 2.0;
      sdp.entry(Q, schur, i + 1, j + 1, 1.0);
      into_s(Q, -twice * second_moment(i, j));
      Eigen::VectorXd product = 2.0 * mean(j) * root.col(i);  // root times 2 Q mean, of this entry of Q
      if (i != j) {
        product += 2.0 * mean(i) * root.col(j);
      }
      into_w(Q, product);
    }
  }
  return sdp.text();
}

double closed_form(const MomentSet& set, const Eigen::VectorXd& h) {
  const NormTerm term{1.0, {}, set.deviation, set.factors};
  return h.dot(set.mean) + std::sqrt(std::min(set.g1, set.g2)) * term.norm(h);
}

}  // namespace evbal
