#include "coordinator/convex/ipopt_nlp.hpp"

#include "coordinator/balancing/formulation.hpp"
#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace evbal {
namespace {

// The derivatives of a robust program, held against central differences at a point inside its domain.
class IpoptNlpDerivatives : public ::testing::Test {
 protected:
  void SetUp() override {
    Ipopt::TNLP::IndexStyleEnum style = Ipopt::TNLP::C_STYLE;
    nlp_.get_nlp_info(n_, m_, jacobian_size_, hessian_size_, style);
    x_.resize(n_);
    for (int i = 0; i < n_; ++i) {
      x_(i) = 1.0 + 0.3 * std::sin(i);
    }
    lambda_.resize(m_);
    for (int i = 0; i < m_; ++i) {
      lambda_(i) = std::cos(i);
    }
  }

  double value(const Eigen::VectorXd& x) {
    double result = 0.0;
    nlp_.eval_f(n_, x.data(), true, result);
    return result;
  }

  Eigen::VectorXd gradient(const Eigen::VectorXd& x) {
    Eigen::VectorXd result(n_);
    nlp_.eval_grad_f(n_, x.data(), true, result.data());
    return result;
  }

  Eigen::VectorXd rows(const Eigen::VectorXd& x) {
    Eigen::VectorXd result(m_);
    nlp_.eval_g(n_, x.data(), true, m_, result.data());
    return result;
  }

  Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) {
    std::vector<int> row(static_cast<std::size_t>(jacobian_size_));
    std::vector<int> column(row.size());
    std::vector<double> values(row.size());
    nlp_.eval_jac_g(n_, nullptr, false, m_, jacobian_size_, row.data(), column.data(), nullptr);
    nlp_.eval_jac_g(n_, x.data(), true, m_, jacobian_size_, nullptr, nullptr, values.data());
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(m_, n_);
    for (std::size_t i = 0; i < row.size(); ++i) {
      result(row[i], column[i]) += values[i];
    }
    return result;
  }

  Eigen::MatrixXd hessian(const Eigen::VectorXd& x, double factor) {
    std::vector<int> row(static_cast<std::size_t>(hessian_size_));
    std::vector<int> column(row.size());
    std::vector<double> values(row.size());
    nlp_.eval_h(n_, nullptr, false, factor, m_, nullptr, false, hessian_size_, row.data(), column.data(), nullptr);
    nlp_.eval_h(n_, x.data(), true, factor, m_, lambda_.data(), true, hessian_size_, nullptr, nullptr, values.data());
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n_, n_);
    for (std::size_t i = 0; i < row.size(); ++i) {
      EXPECT_GE(row[i], column[i]) << "only the lower triangle counts";
      result(row[i], column[i]) += values[i];
      if (row[i] != column[i]) {
        result(column[i], row[i]) += values[i];
      }
    }
    return result;
  }

  static constexpr double h = 1e-5;
  Formulation formulation_ = formulate({}, random_planning_data(3, {.regions = 4, .tau = 2, .rank = 3}),
                                       {.demand = Uncertainty::worst_case, .supply = Uncertainty::worst_case});
  IpoptNlp nlp_{formulation_.program};
  int n_ = 0;
  int m_ = 0;
  int jacobian_size_ = 0;
  int hessian_size_ = 0;
  Eigen::VectorXd x_;
  Eigen::VectorXd lambda_;
};

TEST_F(IpoptNlpDerivatives, AgreeWithCentralDifferences) {
  ASSERT_EQ(formulation_.program.norms().size(), 1U);
  ASSERT_FALSE(formulation_.program.curves().empty());
  const auto exact_gradient = gradient(x_);
  const auto exact_jacobian = jacobian(x_);
  const auto exact_hessian = hessian(x_, 0.7);
  for (int i = 0; i < n_; ++i) {
    Eigen::VectorXd up = x_;
    Eigen::VectorXd down = x_;
    up(i) += h;
    down(i) -= h;
    EXPECT_NEAR(exact_gradient(i), (value(up) - value(down)) / (2 * h), 1e-4);
    EXPECT_LT((exact_jacobian.col(i) - (rows(up) - rows(down)) / (2 * h)).cwiseAbs().maxCoeff(), 1e-7);
    const Eigen::VectorXd slope =
        (0.7 * (gradient(up) - gradient(down)) + (jacobian(up) - jacobian(down)).transpose() * lambda_) / (2 * h);
    EXPECT_LT((exact_hessian.col(i) - slope).cwiseAbs().maxCoeff(), 1e-4);
  }
}

TEST_F(IpoptNlpDerivatives, LiftedNormIsTheNormAtItsBestT) {
  const auto& program = formulation_.program;
  const auto& norm = program.norms().front();
  Eigen::VectorXd x = x_;
  const Eigen::VectorXd z = values_of(norm.variables, x);
  x(program.variables()) = norm.norm(z);
  x.tail(norm.factors.cols()) = norm.factors.transpose() * z;
  EXPECT_NEAR(value(x), program.objective(x.head(program.variables())), 1e-9);
}

}  // namespace
}  // namespace evbal
