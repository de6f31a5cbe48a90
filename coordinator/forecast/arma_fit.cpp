#include "common/contract.hpp"
#include "coordinator/forecast/arma.hpp"

#include <nlopt.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace evbal {
namespace {

/// Coefficients of a stationary autoregression from partial autocorrelations tanh(x) (Durbin and Levinson; Monahan
/// 1984): every x in the real line is allowed.
Eigen::VectorXd coefficients(const Eigen::Ref<const Eigen::VectorXd>& x) {
  Eigen::VectorXd phi(x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const double partial = std::tanh(x(k));
    phi.head(k) -= partial * phi.head(k).reverse().eval();
    phi(k) = partial;
  }
  return phi;
}

ArmaModel model_at(const ArmaOrder& order, const Eigen::VectorXd& x) {
  return {.ar = coefficients(x.head(order.p)), .ma = -coefficients(x.tail(order.q)), .variance = 1.0};
}

/// The model of the coefficients at x with the variance of e that is most likely, and its likelihood.
ArmaFit likelihood(const std::vector<Eigen::VectorXd>& stretches, const ArmaOrder& order, const Eigen::VectorXd& x) {
  ArmaFit fit{.model = model_at(order, x)};
  ArmaFilter filter(fit.model);
  for (const Eigen::VectorXd& stretch : stretches) {
    filter.start();
    for (const double y : stretch) {
      filter.observe(y);
    }
  }
  const double n = filter.count();
  fit.observations = filter.count();
  fit.model.variance = filter.sum_of_squares() / n;
  fit.log_likelihood =
      -0.5 * (n * (std::log(2.0 * std::numbers::pi * fit.model.variance) + 1.0) + filter.sum_of_logs());
  return fit;
}

struct Objective {
  const std::vector<Eigen::VectorXd>& stretches;
  const ArmaOrder& order;

  double operator()(const Eigen::VectorXd& x) const {
    const ArmaFit fit = likelihood(stretches, order, x);
    return -fit.log_likelihood / fit.observations;
  }
};

/// For NLopt: value and, if asked for, gradient by central differences.
double evaluate(unsigned size, const double* at, double* gradient, void* data) {
  constexpr double step = 1e-5;
  const Objective& objective = *static_cast<const Objective*>(data);
  Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(at, size);
  if (gradient != nullptr) {
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double here = x(i);
      x(i) = here + step;
      const double above = objective(x);
      x(i) = here - step;
      gradient[i] = (above - objective(x)) / (2.0 * step);
      x(i) = here;
    }
  }
  return objective(x);
}

}  // namespace

double ArmaFit::aicc() const {
  const double n = observations;
  const double k = model.order().coefficients() + 1;
  return -2.0 * log_likelihood + 2.0 * k * n / (n - k - 1.0);
}

ArmaFit fit_arma(const std::vector<Eigen::VectorXd>& stretches, const ArmaOrder& order) {
  constexpr double farthest = 6.0;  // tanh(6) = 1 - 1e-5
  constexpr int most_evaluations = 200;
  Eigen::VectorXd x(order.coefficients());
  if (x.size() == 0) {
    return likelihood(stretches, order, x);
  }
  x.setConstant(0.1);
  Objective objective{stretches, order};
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> search(
      nlopt_create(NLOPT_LD_SLSQP, static_cast<unsigned>(x.size())), &nlopt_destroy);
  nlopt_set_min_objective(search.get(), evaluate, &objective);
  nlopt_set_lower_bounds1(search.get(), -farthest);
  nlopt_set_upper_bounds1(search.get(), farthest);
  nlopt_set_ftol_abs(search.get(), 1e-12);
  nlopt_set_maxeval(search.get(), most_evaluations);
  double least = 0.0;
  nlopt_optimize(search.get(), x.data(), &least);
  return likelihood(stretches, order, x);
}

ArmaFit choose_arma(const std::vector<Eigen::VectorXd>& stretches, const std::vector<ArmaOrder>& orders) {
  EVBAL_EXPECT(!orders.empty(), "at least one order");
  ArmaFit best;
  double least = std::numeric_limits<double>::infinity();
  for (const ArmaOrder& order : orders) {
    const ArmaFit fit = fit_arma(stretches, order);
    if (fit.aicc() < least) {
      least = fit.aicc();
      best = fit;
    }
  }
  return best;
}

}  // namespace evbal
