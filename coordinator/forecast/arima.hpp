#pragma once

#include "common/eigen.hpp"

#include <Eigen/SparseCore>

#include <vector>

namespace evbal {

/// Seasonal ARIMA (p, d, q)(P, D, Q) with a season of `period` steps, without a mean:
///     phi(B) Phi(B^s) (1 - B)^d (1 - B^s)^D y = theta(B) Theta(B^s) e,
/// phi(B) = 1 - phi_1 B - ..., theta(B) = 1 + theta_1 B + ... (Box and Jenkins; signs as in R's `arima`).
struct ArimaOrder {
  int p = 0;
  int d = 0;
  int q = 0;
  int P = 0;
  int D = 0;
  int Q = 0;
  int period = 1;

  int coefficients() const { return p + q + P + Q; }
  bool operator==(const ArimaOrder&) const = default;
};

/// An order with its coefficients.
struct ArimaModel {
  ArimaOrder order;
  Eigen::VectorXd ar;           ///< phi, p
  Eigen::VectorXd ma;           ///< theta, q
  Eigen::VectorXd seasonal_ar;  ///< Phi, P
  Eigen::VectorXd seasonal_ma;  ///< Theta, Q
  double variance = 0.0;        ///< of e
};

/// Whether y = sum ar_k B^k y + e has a stationary solution: disturbances die away.
bool stationary(const Eigen::VectorXd& ar);

/// Mean and variance of the steps ahead.
struct Outlook {
  Eigen::VectorXd mean;
  Eigen::VectorXd variance;
};

/// How far an observation lay off what was expected of it, and the variance that this had.
struct Innovation {
  double value = 0.0;
  double variance = 0.0;
};

/// Kalman filter of an ARIMA model in state-space form (Harvey 1993, section 4.4; Gardner, Harvey and Phillips 1980),
/// for one stretch of observations. ARMA states start from their stationary covariance, differenced ones from a diffuse
/// prior.
class ArimaFilter {
 public:
  explicit ArimaFilter(const ArimaModel& model);

  /// Takes the next observation; NaN if it is missing. Gives what it was off, NaN if it is missing.
  Innovation observe(double y);

  /// The `steps` observations that come next.
  Outlook outlook(int steps) const;

  /// Of the standardised innovations so far: their number, sum of squares, and sum of the logarithms of their variances
  /// (in units of the model's). Those that the diffuse prior dominates do not count.
  int count() const { return count_; }
  double sum_of_squares() const { return squares_; }
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
struct ArimaFit {
  ArimaModel model;
  double log_likelihood = 0.0;
  int observations = 0;  ///< that count

  /// Akaike's criterion, corrected for small samples (Hurvich and Tsai 1989); the variance counts as a parameter.
  double aicc() const;
};

/// Maximises the exact Gaussian likelihood of `stretches`, which are independent of each other (days whose nights are
/// skipped) and may have gaps (NaN). AR and MA parts stay stationary and invertible. Needs more observations than
/// coefficients, and one that is not 0. Deterministic.
ArimaFit fit_arima(const std::vector<Eigen::VectorXd>& stretches, const ArimaOrder& order);

/// The fit of least AICc among `orders`, the first of equals; at least one.
ArimaFit choose_arima(const std::vector<Eigen::VectorXd>& stretches, const std::vector<ArimaOrder>& orders);

}  // namespace evbal
