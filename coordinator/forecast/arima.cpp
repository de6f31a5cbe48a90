#include "coordinator/forecast/arima.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

using Polynomial = Eigen::VectorXd;  // coefficients of 1, B, B^2, ...

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial out = Polynomial::Zero(a.size() + b.size() - 1);
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    out.segment(i, b.size()) += a(i) * b;
  }
  return out;
}

/// 1 + sign (c_1 B^s + c_2 B^2s + ...)
Polynomial lag_polynomial(const Eigen::VectorXd& coefficients, double sign, int period) {
  Polynomial out = Polynomial::Zero(coefficients.size() * period + 1);
  out(0) = 1.0;
  for (Eigen::Index i = 0; i < coefficients.size(); ++i) {
    out((i + 1) * period) = sign * coefficients(i);
  }
  return out;
}

/// (1 - B)^d (1 - B^s)^D
Polynomial difference(const ArimaOrder& order) {
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  Polynomial out = Polynomial::Ones(1);
  for (int i = 0; i < order.d; ++i) {
    out = product(out, lag_polynomial(one, -1.0, 1));
  }
  for (int i = 0; i < order.D; ++i) {
    out = product(out, lag_polynomial(one, -1.0, order.period));
  }
  return out;
}

/// Solves P = T P T' + v v' by doubling: the sum over T^k v v' T^k' takes twice as many terms each time.
Eigen::MatrixXd stationary_covariance(const Eigen::MatrixXd& transition, const Eigen::VectorXd& noise) {
  constexpr int most_doublings = 60;
  constexpr double negligible = 1e-14;
  Eigen::MatrixXd power = transition;
  Eigen::MatrixXd sum = noise * noise.transpose();
  for (int i = 0; i < most_doublings; ++i) {
    const Eigen::MatrixXd more = power * sum * power.transpose();
    sum += more;
    if (more.cwiseAbs().maxCoeff() <= negligible * sum.cwiseAbs().maxCoeff()) {
      break;
    }
    power = (power * power).eval();
  }
  return sum;
}

constexpr double diffuse_variance = 1e6;  // in units of the innovations', as R's kappa
constexpr double least_diffuse = 1e4;     // an innovation of such variance tells of the prior, not of the model

}  // namespace

// Steps back through Durbin and Levinson's recursion: all partial autocorrelations lie within (-1, 1).
bool stationary(const Eigen::VectorXd& ar) {
  Eigen::VectorXd phi = ar;
  for (Eigen::Index k = ar.size() - 1; k >= 0; --k) {
    const double partial = phi(k);
    if (!(std::abs(partial) < 1.0)) {
      return false;
    }
    phi.head(k) = ((phi.head(k) + partial * phi.head(k).reverse()) / (1.0 - partial * partial)).eval();
  }
  return true;
}

// State: ARMA states first (Harvey's form, companion of phi), then the last values of y as differencing needs them.
ArimaFilter::ArimaFilter(const ArimaModel& model) : variance_(model.variance) {
  const Polynomial phi = product(lag_polynomial(model.ar, -1.0, 1),  //
                                 lag_polynomial(model.seasonal_ar, -1.0, model.order.period));
  const Polynomial theta = product(lag_polynomial(model.ma, 1.0, 1),  //
                                   lag_polynomial(model.seasonal_ma, 1.0, model.order.period));
  const Polynomial delta = difference(model.order);
  const Eigen::Index arma = std::max(phi.size() - 1, theta.size());
  const Eigen::Index past = delta.size() - 1;

  observation_ = Eigen::VectorXd::Zero(arma + past);
  observation_(0) = 1.0;
  observation_.tail(past) = -delta.tail(past);
  noise_ = Eigen::VectorXd::Zero(arma + past);
  noise_.head(theta.size()) = theta;

  Eigen::MatrixXd transition = Eigen::MatrixXd::Zero(arma + past, arma + past);
  transition.col(0).head(phi.size() - 1) = -phi.tail(phi.size() - 1);
  transition.topLeftCorner(arma, arma).diagonal(1).setOnes();
  if (past > 0) {
    transition.row(arma) = observation_;
    transition.bottomRightCorner(past, past).diagonal(-1).setOnes();
  }
  first_covariance_ = diffuse_variance * Eigen::MatrixXd::Identity(arma + past, arma + past);
  first_covariance_.topLeftCorner(arma, arma) =
      stationary_covariance(transition.topLeftCorner(arma, arma), noise_.head(arma));
  transition_ = transition.sparseView();
  start();
}

void ArimaFilter::start() {
  state_ = Eigen::VectorXd::Zero(observation_.size());
  covariance_ = first_covariance_;
}

void ArimaFilter::predict(Eigen::VectorXd& state, Eigen::MatrixXd& covariance) const {
  state = (transition_ * state).eval();
  const Eigen::MatrixXd moved = transition_ * covariance;
  covariance.noalias() = moved * transition_.transpose();
  covariance.noalias() += noise_ * noise_.transpose();
}

Innovation ArimaFilter::observe(double y) {
  const Innovation off{y - observation_.dot(state_), variance_ * observation_.dot(covariance_ * observation_)};
  if (!std::isnan(y)) {
    const Eigen::VectorXd gain = covariance_ * observation_;
    const double variance = observation_.dot(gain);
    const double innovation = y - observation_.dot(state_);
    if (variance < least_diffuse) {
      ++count_;
      squares_ += innovation * innovation / variance;
      logs_ += std::log(variance);
    }
    state_ += gain * (innovation / variance);
    covariance_.noalias() -= gain * gain.transpose() / variance;
  }
  predict(state_, covariance_);
  return off;
}

Outlook ArimaFilter::outlook(int steps) const {
  Outlook out{Eigen::VectorXd(steps), Eigen::VectorXd(steps)};
  Eigen::VectorXd state = state_;
  Eigen::MatrixXd covariance = covariance_;
  for (int step = 0; step < steps; ++step) {
    out.mean(step) = observation_.dot(state);
    out.variance(step) = variance_ * observation_.dot(covariance * observation_);
    predict(state, covariance);
  }
  return out;
}

}  // namespace evbal
