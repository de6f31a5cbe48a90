#include "coordinator/forecast/arma.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

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

bool invertible(const Eigen::VectorXd& ma) {
  return stationary(-ma);
}

// Harvey's form: the transition is the companion of ar, the first state is y.
ArmaFilter::ArmaFilter(const ArmaModel& model) : variance_(model.variance) {
  const Eigen::Index size = std::max(model.ar.size(), model.ma.size() + 1);
  observation_ = Eigen::VectorXd::Unit(size, 0);
  noise_ = Eigen::VectorXd::Unit(size, 0);
  noise_.segment(1, model.ma.size()) = model.ma;
  Eigen::MatrixXd transition = Eigen::MatrixXd::Zero(size, size);
  transition.col(0).head(model.ar.size()) = model.ar;
  transition.diagonal(1).setOnes();
  first_covariance_ = stationary_covariance(transition, noise_);
  transition_ = transition.sparseView();
  start();
}

void ArmaFilter::start() {
  state_ = Eigen::VectorXd::Zero(observation_.size());
  covariance_ = first_covariance_;
}

void ArmaFilter::predict(Eigen::VectorXd& state, Eigen::MatrixXd& covariance) const {
  state = (transition_ * state).eval();
  const Eigen::MatrixXd moved = transition_ * covariance;
  covariance.noalias() = moved * transition_.transpose();
  covariance.noalias() += noise_ * noise_.transpose();
}

Innovation ArmaFilter::observe(double y) {
  const Eigen::VectorXd gain = covariance_ * observation_;
  const double variance = observation_.dot(gain);
  const double innovation = y - observation_.dot(state_);
  if (!std::isnan(y)) {
    ++count_;
    squares_ += innovation * innovation / variance;
    logs_ += std::log(variance);
    state_ += gain * (innovation / variance);
    covariance_.noalias() -= gain * gain.transpose() / variance;
  }
  predict(state_, covariance_);
  return {innovation, variance_ * variance};
}

Outlook ArmaFilter::outlook(int steps) const {
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
