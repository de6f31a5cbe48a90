#include "coordinator/balancing/shortage_terms.hpp"

#include "coordinator/balancing/hinges.hpp"
#include "coordinator/balancing/worst_case.hpp"

#include <vector>

namespace evbal {
namespace {

// E[max(0, price (factor S - r))]: a hinge for each value of r.
void add_expected_hinges(std::vector<Hinge>& hinges, const char* term, double price, const DiscreteDistribution& r,
                         double factor) {
  if (price == 0.0 || factor == 0.0) {
    return;
  }
  for (std::size_t m = 0; m < r.values.size(); ++m) {
    hinges.push_back({term, price * factor * r.probabilities[m], r.values[m] / factor});
  }
}

}  // namespace

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
    case Shortage::flow:
      return;  // flow_terms.hpp
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
  for (int i = 0; i < S.size(); ++i) {
    const int entry = k * S.size() + i;
    std::vector<Hinge> hinges;
    add_expected_hinges(hinges, "shortage", -p_.p_shortage, model_.shortage[entry], h(k));
    add_expected_hinges(hinges, "surplus", p_.p_surplus, model_.surplus[entry], l(k));
    minimise_hinges(program_, S[i], hinges, {"shortage", k, i});
  }
}

// p_s psi(h S_i - r_hat_i) + p_o psi(r_hat_i - l S_i)
void ShortageTerms::moments(int k, const Variables& S) {
  const auto& set = data_.demand;
  constexpr double least = 0.1;  // vehicles, so that psi bends no more sharply than an engine can follow
  const Eigen::VectorXd deviation = set.standard_deviation().cwiseMax(least);
  const Eigen::MatrixXd sigma = deviation.reshaped(model_.r_hat.rows(), model_.r_hat.cols());
  for (int i = 0; i < S.size(); ++i) {
    const double r_hat = model_.r_hat(i, k);
    const auto psi = worst_case_shortage(sigma(i, k), set.g1, set.g2);
    curve({"shortage", k, i}, p_.p_shortage, S[i], of_line(psi, h(k), -r_hat));
    curve({"surplus", k, i}, p_.p_surplus, S[i], of_line(psi, -l(k), r_hat));
  }
}

// p_r r_hat_i / (S_i + 1/2)
void ShortageTerms::ratio(int k, const Variables& S) {
  const auto reciprocal = inverse_power(0.5, 1.0);
  for (int i = 0; i < S.size(); ++i) {
    curve({"shortage", k, i}, p_.p_ratio * model_.r_hat(i, k), S[i], reciprocal);
  }
}

// p_s E[max(0, r_i - S_i - phi (1 - pl_i) A_i)]
void ShortageTerms::turnover(int k, const Variables& S) {
  for (int i = 0; i < S.size(); ++i) {
    std::vector<Hinge> hinges;
    add_expected_hinges(hinges, "shortage", -p_.p_shortage, model_.shortage[k * S.size() + i], 1.0);
    for (Hinge& hinge : hinges) {
      hinge.bend -= model_.serving_again(i, k);
    }
    minimise_hinges(program_, S[i], hinges, {"shortage", k, i});
  }
}

// price function(of)
void ShortageTerms::curve(const Name& name, double price, Variable of, const ConvexFunctionPtr& function) {
  if (price > 0.0) {
    program_.minimise_curve(name.what, price, of, function, name);
  }
}

}  // namespace evbal
