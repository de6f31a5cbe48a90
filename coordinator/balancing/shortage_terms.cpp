#include "coordinator/balancing/shortage_terms.hpp"

#include "coordinator/balancing/worst_case.hpp"

#include <algorithm>

namespace evbal {

ShortageTerms::ShortageTerms(const BalancingParameters& parameters, const PlanningData& data,
                             const FormulationOptions& options, const UncertaintyModel& model, ConvexProgram& program)
    : p_(parameters),
      data_(data),
      options_(options),
      model_(model),
      program_(program),
      rho_(demand_per_vehicle(data, model)) {}

void ShortageTerms::add(int k, const Variables& S) {
  switch (options_.shortage) {
    case Shortage::band:
      return band(k, S);
    case Shortage::moments:
      return moments(k, S);
    case Shortage::ratio:
      return ratio(k, S);
    case Shortage::turnover:
      return turnover(k, S);
    case Shortage::own:
      return options_.own(k, S, model_, program_);
  }
}

// h, l = rho_k (1 +- eta)
double ShortageTerms::h(int k) const {
  return rho_(k) * (1.0 + p_.eta);
}
double ShortageTerms::l(int k) const {
  return rho_(k) * (1.0 - p_.eta);
}

// p_s E[max(0, r_i - h S_i)] + p_o E[max(0, l S_i - r_i)]
void ShortageTerms::band(int k, const Variables& S) {
  for (std::size_t i = 0; i < S.size(); ++i) {
    const auto entry = static_cast<std::size_t>(k) * S.size() + i;
    expected_shortage("shortage", k, p_.p_shortage, model_.shortage[entry], h(k) * Expression(S[i]));
    expected_shortage("surplus", k, p_.p_surplus, mirrored(model_.surplus[entry]), -l(k) * Expression(S[i]));
  }
}

// p_s psi(h S_i - r_hat_i) + p_o psi(r_hat_i - l S_i)
void ShortageTerms::moments(int k, const Variables& S) {
  const auto& set = data_.demand;
  constexpr double least = 0.1;  // vehicles, so that psi bends no more sharply than an engine can follow
  const Eigen::VectorXd deviation = set.standard_deviation().cwiseMax(least);
  const Eigen::MatrixXd sigma = deviation.reshaped(model_.r_hat.rows(), model_.r_hat.cols());
  for (std::size_t at = 0; at < S.size(); ++at) {
    const auto i = static_cast<Eigen::Index>(at);
    const double r_hat = model_.r_hat(i, k);
    const auto psi = worst_case_shortage(sigma(i, k), set.g1, set.g2);
    curve("shortage", k, p_.p_shortage, S[at], of_line(psi, h(k), -r_hat));
    curve("surplus", k, p_.p_surplus, S[at], of_line(psi, -l(k), r_hat));
  }
}

// p_r r_hat_i / (S_i + 1/2)
void ShortageTerms::ratio(int k, const Variables& S) {
  const auto reciprocal = inverse_power(0.5, 1.0);
  for (std::size_t i = 0; i < S.size(); ++i) {
    const double r_hat = model_.r_hat(static_cast<Eigen::Index>(i), k);
    curve("ratio", k, p_.p_ratio * r_hat, S[i], reciprocal);
  }
}

// p_s E[max(0, r_i - S_i - phi (1 - pl_i) A_i)]
void ShortageTerms::turnover(int k, const Variables& S) {
  for (std::size_t i = 0; i < S.size(); ++i) {
    const auto entry = static_cast<std::size_t>(k) * S.size() + i;
    const double again = model_.serving_again(static_cast<Eigen::Index>(i), k);
    expected_shortage("shortage", k, p_.p_shortage, model_.shortage[entry], Expression(S[i]) + again);
  }
}

void ShortageTerms::curve(const char* name, int k, double price, Variable of, const ConvexFunctionPtr& function) {
  if (price > 0.0) {
    program_.minimise_curve(label(name, k), price, of, function);
  }
}

// price E[max(0, r - s)]  =  price min sum_m P(r >= v_m) part_m    over    sum_m part_m >= v_M - s,
// part_m <= v_m - v_(m-1):  what is missing, from the part that is least likely to be missed.
void ShortageTerms::expected_shortage(const char* name, int k, double price, const DiscreteDistribution& law,
                                      const Expression& s) {
  if (price == 0.0) {
    return;
  }
  const auto& v = law.values;
  const Variables parts = program_.add_block(label(name, k), static_cast<int>(v.size()));
  Expression missing;
  double probability = 1.0;
  for (std::size_t m = 0; m < v.size(); ++m) {
    missing += parts[m];
    program_.minimise(price * probability * Expression(parts[m]));
    program_.bound(parts[m], 0.0, m == 0 ? ConvexProgram::infinity : v[m] - v[m - 1]);
    probability = std::max(0.0, probability - law.probabilities[m]);
  }
  program_.at_most(v.back() - s, missing);
}

}  // namespace evbal
