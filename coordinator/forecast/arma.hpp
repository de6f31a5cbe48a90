#pragma once

#include "common/eigen.hpp"

#include <Eigen/SparseCore>

#include <vector>

namespace evbal {

/// How many autoregressive (p) and moving-average (q) coefficients an ArmaModel has.
struct ArmaOrder {
  int p = 0;  ///< autoregressive coefficients
  int q = 0;  ///< moving-average coefficients

  /// Number of coefficients.
  int coefficients() const { return p + q; }
  /// Field by field.
  bool operator==(const ArmaOrder&) const = default;
};

/// An autoregressive moving average without a mean:
///     y_t = ar_1 y_(t-1) + ... + ar_p y_(t-p) + e_t + ma_1 e_(t-1) + ... + ma_q e_(t-q)
/// (signs as in R's `arima`).
struct ArmaModel {
  Eigen::VectorXd ar;     ///< p, stationary
  Eigen::VectorXd ma;     ///< q, invertible
  double variance = 0.0;  ///< of e

  /// By the lengths of its coefficients.
  ArmaOrder order() const { return {static_cast<int>(ar.size()), static_cast<int>(ma.size())}; }
};

/// Whether y_t = sum ar_k y_(t-k) + e_t has a stationary solution: disturbances die away.
bool stationary(const Eigen::VectorXd& ar);

/// Whether e can be found from y where y_t = e_t + sum ma_k e_(t-k).
bool invertible(const Eigen::VectorXd& ma);

/// Mean and variance of the steps ahead.
struct Outlook {
  Eigen::VectorXd mean;      ///< by step ahead
  Eigen::VectorXd variance;  ///< by step ahead
};

/// An observation less what was expected of it a step before, and the variance that this difference had.
struct Innovation {
  double value = 0.0;     ///< observed less expected
  double variance = 0.0;  ///< that the filter gave it
};

/// Kalman filter of an ARMA model in state-space form (Harvey 1993, section 4.4; Gardner, Harvey and Phillips 1980),
/// for one stretch of observations. The state starts from its stationary distribution.
class ArmaFilter {
 public:
  /// Starts before the first observation.
  explicit ArmaFilter(const ArmaModel& model);

  /// Takes the next observation; NaN if it is missing. Gives its innovation, NaN if it is missing.
  Innovation observe(double y);

  /// The `steps` observations that come next.
  Outlook outlook(int steps) const;

  /// Of the innovations so far, with variances in units of the model's: their number, the sum of their squares divided
  /// by their variances, and the sum of the logarithms of these variances.
  int count() const { return count_; }
  /// See count().
  double sum_of_squares() const { return squares_; }
  /// See count().
  double sum_of_logs() const { return logs_; }

  /// Back to before the first observation; what was counted stays.
  void start();

 private:
  void predict(Eigen::VectorXd& state, Eigen::MatrixXd& covariance) const;

  double variance_;
  Eigen::SparseMatrix<double> transition_;
  Eigen::VectorXd noise_;
  Eigen::VectorXd observation_;
  Eigen::MatrixXd first_covariance_;
  Eigen::VectorXd state_;
  Eigen::MatrixXd covariance_;
  int count_ = 0;
  double squares_ = 0.0;
  double logs_ = 0.0;
};

/// A model by maximum likelihood.
struct ArmaFit {
  ArmaModel model;              ///< of the greatest likelihood
  double log_likelihood = 0.0;  ///< of the model
  int observations = 0;         ///< that are not missing

  /// Akaike's criterion, corrected for small samples (Hurvich and Tsai 1989); the variance counts as a parameter.
  double aicc() const;
};

/// Maximises the exact Gaussian likelihood of `stretches`, which are independent of each other (days whose nights are
/// skipped) and may have gaps (NaN). AR and MA parts stay stationary and invertible. Needs more observations than
/// coefficients, and one that is not 0. Deterministic.
ArmaFit fit_arma(const std::vector<Eigen::VectorXd>& stretches, const ArmaOrder& order);

/// The fit of least AICc among `orders`, the first of equals; at least one.
ArmaFit choose_arma(const std::vector<Eigen::VectorXd>& stretches, const std::vector<ArmaOrder>& orders);

}  // namespace evbal
