#include "coordinator/balancing/formulation.hpp"

#include "coordinator/balancing/shortage_terms.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace evbal {
namespace {

using Expressions = std::vector<Expression>;

Expressions constants(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

bool is_zero(const Expression& expression) {
  return expression.terms().empty() && expression.constant() <= 0.0;
}

// Vehicles at the start of a step.
struct Stock {
  Expressions V, O, L, B;
};

// Variables of one step that later equations use.
struct Step {
  Variables S, Y, u, e;
};

class Formulator {
 public:
  Formulator(const BalancingParameters& parameters, const PlanningData& data, const FormulationOptions& options)
      : p_(parameters),
        data_(data),
        model_(uncertainty_model(parameters, data, options)),
        shortage_(parameters, data, options, model_, program_),
        size_(static_cast<int>(data.km.rows())),
        horizon_(static_cast<int>(data.points.cols())) {
    for (int i = 0; i < size_; ++i) {
      station_.push_back(data.points.row(i).maxCoeff() > 0.0);
    }
    vacant_arcs_ = vacant_arcs(data.km, p_.m1, p_.neighbours);
    low_battery_arcs_ = low_battery_arcs(data.km, station_, p_.m2, p_.neighbours);
  }

  Formulation formulate() {
    Stock stock{constants(data_.state.vacant), constants(data_.state.occupied), constants(data_.state.low_battery),
                constants(data_.state.plugged)};
    for (int k = 0; k < horizon_; ++k) {
      Step step;
      step.S = send("x", "S", k, vacant_arcs_, stock.V, 1.0, result_.vacant);
      step.Y = send("y", "Y", k, low_battery_arcs_, stock.L, p_.beta, result_.low_battery);
      charge(k, stock, step);
      shortage_.add(k, step.S);
      utilisation(k, step);
      if (k + 1 < horizon_) {
        stock = next(k, stock, step);
      }
    }
    worst_case_utilisation();
    return std::move(result_);
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  Variables block(const std::string& name, int k, double lower = 0.0) {
    return program_.add_block(label(name, k), size_, lower);
  }

  // S_i = V_i + sum_j x_ji - sum_j x_ij,    sum_j x_ij <= V_i,    cost: price sum w x.     Likewise Y, L, y.
  Variables send(const std::string& name, const std::string& after_name, int k, const std::vector<Arc>& arcs,
                 const Expressions& stock, double price, std::vector<std::vector<ArcFlow>>& flows) {
    Variables after = block(after_name, k, -ConvexProgram::infinity);
    Expressions in(at(size_));
    Expressions out(at(size_));
    Expression km;
    auto& step_flows = flows.emplace_back();
    for (const auto& arc : arcs) {
      if (is_zero(stock[at(arc.from)])) {
        continue;
      }
      const Variable x = program_.add_block(label(name, k), 1).front();
      step_flows.push_back({arc, x});
      out[at(arc.from)] += x;
      in[at(arc.to)] += x;
      km.add(arc.km, x);
    }
    for (int i = 0; i < size_; ++i) {
      program_.equal(after[at(i)], stock[at(i)] + in[at(i)] - out[at(i)]);
      program_.at_most(out[at(i)], stock[at(i)]);
    }
    program_.minimise(price * km);
    return after;
  }

  // u_i <= Y_i,   u_i <= P_i - B_i + e_i + z_i   (u_i = 0 outside C),      e_i <= B_i,   e_i <= c_low_i
  // cost: omega sum_i (Y_i - u_i) + pi_e sum_i (c_low_i - e_i), and z above any gain from u
  void charge(int k, const Stock& stock, Step& step) {
    constexpr double z_price = 1000.0;
    step.u = block("u", k);
    step.e = block("e", k);
    const Variables z = block("z", k);
    for (int i = 0; i < size_; ++i) {
      const Expression& B = stock.B[at(i)];
      const Expression e = step.e[at(i)];
      const Expression u = step.u[at(i)];
      const Expression Y = step.Y[at(i)];
      const double c_low = model_.c_low(i, k);
      program_.bound(step.e[at(i)], 0.0, is_zero(B) ? 0.0 : c_low);
      program_.at_most(e, B);
      if (station_[at(i)]) {
        program_.at_most(u, Y);
        program_.at_most(u, data_.points(i, k) - B + e + z[at(i)]);
      } else {
        program_.bound(step.u[at(i)], 0.0, 0.0);
        program_.bound(z[at(i)], 0.0, 0.0);
      }
      program_.minimise(p_.omega * (Y - u) + p_.pi_e * (c_low - e));
      program_.penalise(z_price * Expression(z[at(i)]));
    }
  }

  // theta c_hat_i Z_i,    Z_i >= (Y_i + eps)^(-a),    theta = theta_0 / a,    where points work
  void utilisation(int k, const Step& step) {
    const double theta = p_.theta_0 / p_.a;
    const auto power = inverse_power(p_.eps, p_.a);
    for (int i = 0; i < size_; ++i) {
      const double c_hat = model_.c_hat(i, k);
      if (theta == 0.0 || data_.points(i, k) <= 0.0 || (c_hat == 0.0 && model_.supply_radius == 0.0)) {
        continue;
      }
      utilised_.push_back({k * size_ + i, program_.minimise_curve(label("Z", k), theta * c_hat, step.Y[at(i)], power)});
    }
  }

  // theta sqrt(g) || Sigma_c^(1/2) Z ||  over the whole horizon
  void worst_case_utilisation() {
    const double weight = p_.theta_0 / p_.a * model_.supply_radius;
    if (weight == 0.0 || utilised_.empty()) {
      return;
    }
    const auto& set = supply_of(p_, data_);
    const auto count = static_cast<Eigen::Index>(utilised_.size());
    NormTerm norm{weight, {}, Eigen::VectorXd(count), Eigen::MatrixXd(count, set.factors.cols())};
    for (Eigen::Index n = 0; n < count; ++n) {
      const auto& [entry, Z] = utilised_[static_cast<std::size_t>(n)];
      norm.variables.push_back(Z.index);
      norm.deviation(n) = set.deviation(entry);
      norm.factors.row(n) = set.factors.row(entry);
    }
    program_.minimise_norm(std::move(norm));
  }

  // V+_i = sum_j Pv_ji S_j + sum_j Qv_ji O_j + e_i + aV+_i          L+_i = Y_i - u_i + sum_j Pl_ji S_j + aL+_i
  // O+_i = sum_j Po_ji S_j + sum_j Qo_ji O_j                        B+_i = B_i + u_i - e_i
  Stock next(int k, const Stock& stock, const Step& step) {
    const auto& move = data_.transitions[at(k)];
    Stock next;
    const bool occupied_matter = k + 2 < horizon_;  // they come back as vacant one step later
    for (int i = 0; i < size_; ++i) {
      Expression V = Expression(step.e[at(i)]) + data_.state.arriving_vacant(i, k);
      Expression O;
      Expression L = Expression(step.Y[at(i)]) - step.u[at(i)] + data_.state.arriving_low_battery(i, k);
      for (int j = 0; j < size_; ++j) {
        V.add(move.vacant_to_vacant(j, i), step.S[at(j)]).add(move.occupied_to_vacant(j, i), stock.O[at(j)]);
        L.add(move.vacant_to_low_battery(j, i), step.S[at(j)]);
        if (occupied_matter) {
          O.add(move.vacant_to_occupied(j, i), step.S[at(j)]).add(move.occupied_to_occupied(j, i), stock.O[at(j)]);
        }
      }
      next.V.push_back(named("V", k + 1, V));
      next.L.push_back(named("L", k + 1, L));
      next.O.push_back(occupied_matter ? named("O", k + 1, O) : O);
      next.B.push_back(named("B", k + 1, stock.B[at(i)] + step.u[at(i)] - step.e[at(i)]));
    }
    return next;
  }

  // A variable that stands for a long expression, so that each row stays short.
  Variable named(const std::string& name, int k, const Expression& expression) {
    const Variable variable = program_.add_block(label(name, k), 1, -ConvexProgram::infinity).front();
    program_.equal(variable, expression);
    return variable;
  }

  struct Utilised {
    int entry = 0;  // in the stacked vector of completions
    Variable Z;
  };

  const BalancingParameters& p_;
  const PlanningData& data_;
  Formulation result_;
  ConvexProgram& program_ = result_.program;
  UncertaintyModel model_;
  ShortageTerms shortage_;
  int size_;
  int horizon_;
  std::vector<bool> station_;  // C: points work at some step of the horizon
  std::vector<Arc> vacant_arcs_;
  std::vector<Arc> low_battery_arcs_;
  std::vector<Utilised> utilised_;
};

std::vector<std::vector<Flow>> flows_at(const std::vector<std::vector<ArcFlow>>& steps, const Eigen::VectorXd& x) {
  constexpr double negligible = 1e-6;
  std::vector<std::vector<Flow>> flows;
  for (const auto& step : steps) {
    auto& kept = flows.emplace_back();
    for (const auto& [arc, amount] : step) {
      if (x(amount.index) >= negligible) {
        kept.push_back({arc.from, arc.to, x(amount.index)});
      }
    }
  }
  return flows;
}

}  // namespace

Formulation formulate(const BalancingParameters& parameters, const PlanningData& data,
                      const FormulationOptions& options) {
  return Formulator(parameters, data, options).formulate();
}

Dispatch dispatch_at(const Formulation& formulation, const Eigen::VectorXd& x) {
  return {.vacant = flows_at(formulation.vacant, x), .low_battery = flows_at(formulation.low_battery, x)};
}

}  // namespace evbal
