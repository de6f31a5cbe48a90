#include "coordinator/balancing/formulation.hpp"

#include "coordinator/balancing/flow_terms.hpp"
#include "coordinator/balancing/send_limits.hpp"
#include "coordinator/balancing/shortage_terms.hpp"
#include "coordinator/balancing/top_up.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace evbal {
namespace {

Expressions constants(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

Expressions each_of(const Variables& variables) {
  Expressions all;
  for (int i = 0; i < variables.size(); ++i) {
    all.emplace_back(variables[i]);
  }
  return all;
}

bool is_zero(const Expression& expression) {
  return expression.terms().empty() && expression.constant() <= 0.0;
}

// What later equations use of one step.
struct Step {
  Expressions S, Y, u, e;
};

// What is sent in one step: from and to each region, and how far in all.
struct Sent {
  Expressions in, out;
  Expression km;
};

// Writes down the problem that stands on top of formulation.hpp, equation by equation.
class Formulator {
 public:
  Formulator(const BalancingParameters& parameters, const PlanningData& data, const FormulationOptions& options)
      : p_(parameters),
        data_(data),
        options_(options),
        model_(uncertainty_model(parameters, data, options)),
        shortage_(parameters, data, options, model_, program_),
        N_(static_cast<int>(data.km.rows())),
        tau_(static_cast<int>(data.points.cols())),
        topped_up_(data.km.rows()),
        session_(static_cast<int>(std::ceil(data.mean_session_minutes / data.step_minutes))) {
    for (int i = 0; i < N_; ++i) {
      station_.push_back(data.points.row(i).maxCoeff() > 0.0);
    }
    vacant_arcs_ = vacant_arcs(data.km, p_.m1, p_.neighbours);
    low_battery_arcs_ = low_battery_arcs(data.km, station_, p_.m2, p_.neighbours);
  }

  Formulation formulate() {
    const bool flow = options_.shortage == Shortage::flow;
    const Eigen::MatrixXd unsent = flow ? vacant_without_dispatch(data_, model_.c_low) : Eigen::MatrixXd();
    result_.stock.push_back({constants(data_.state.vacant), constants(data_.state.occupied),
                             constants(data_.state.low_battery), constants(data_.state.plugged)});
    result_.top_up = add_top_ups(p_, data_, program_);
    for (const auto& [arc, amount] : result_.top_up) {
      topped_up_[arc.from] += amount;
    }
    for (int k = 0; k < tau_; ++k) {
      const Stock& stock = result_.stock[k];
      Step step;
      const Variables S = flow ? Variables() : send_vacant(k, stock.V);
      step.S = flow ? constants(unsent.col(k)) : each_of(S);
      step.Y = send_low_battery(k, stock.L);
      charge(k, stock.B, step);
      shortage_.add(k, S);
      if (k + 1 < tau_) {
        result_.stock.push_back(next_stock(k, stock, step));
      }
    }
    worst_case_utilisation();
    if (flow) {
      result_.vacant.resize(tau_);
      result_.vacant.front() = add_flow(p_, data_, options_.demand, result_.top_up, program_);
    }
    return std::move(result_);
  }

 private:
  // S_i = V_i + come_i - t_i + sum_j x_ji - sum_j x_ij,    come_i + sum_j x_ji <= S_i,    cost: sum w x
  Variables send_vacant(int k, const Expressions& V) {
    const Variables S = program_.add_block({"S", k}, N_, -ConvexProgram::infinity);
    const Sent x = send("x", k, vacant_arcs_, V, result_.vacant);
    for (int i = 0; i < N_; ++i) {
      const Expression come = data_.state.arriving_vacant(i, k) + topped_up(i, k == session_);
      program_.add(S[i] == V[i] + come - topped_up(i, k == 0) + x.in[i] - x.out[i], {"supply", k, i});
      if (!x.out[i].terms().empty()) {
        program_.add(come + x.in[i] <= S[i], {"sent", k, i});
      }
    }
    program_.minimise("km", x.km);
    return S;
  }

  // t_i, in the steps in which it counts
  Expression topped_up(int i, bool counts) const { return counts ? topped_up_[i] : 0.0; }

  // Y_i = L_i + aL_i + sum_j y_ji - sum_j y_ij,    aL_i + sum_j y_ji <= Y_i,    cost: beta sum w y
  Expressions send_low_battery(int k, const Expressions& L) {
    const Sent y = send("y", k, low_battery_arcs_, L, result_.low_battery);
    Expressions Y;
    for (int i = 0; i < N_; ++i) {
      const double come = data_.state.arriving_low_battery(i, k);
      Y.push_back(L[i] + come + y.in[i] - y.out[i]);
      if (station_[i]) {
        const Variable there = variable_for(Y[i], {"Y", k, i}, {"low-battery", k, i});
        utilisation(k, i, there);
        Y[i] = there;
      }
      if (!y.out[i].terms().empty()) {
        program_.add(come + y.in[i] <= Y[i], {"sent to charge", k, i});
      }
    }
    if (k == 0) {
      stay_within_reach();
    }
    program_.minimise("km", p_.beta * y.km);
    return Y;
  }

  // sum_(j: w_ij >= w) y_ij <= R_i(w)
  void stay_within_reach() {
    std::vector<Arc> arcs;
    for (const auto& flow : result_.low_battery.front()) {
      arcs.push_back(flow.arc);
    }
    for (const auto& limit : reach_limits(data_.state, arcs)) {
      Expression sent;
      for (const auto& [arc, amount] : result_.low_battery.front()) {
        const bool is_far = std::ranges::find(limit.targets, arc.to) != limit.targets.end();
        sent.add(arc.from == limit.from && is_far ? 1.0 : 0.0, amount);
      }
      program_.add(sent <= limit.most, {"within reach", 0, limit.from});
    }
  }

  // One variable per arc that leaves a region with vehicles.
  Sent send(const char* name, int k, const std::vector<Arc>& arcs, const Expressions& stock,
            std::vector<std::vector<ArcFlow>>& flows) {
    Sent sent{Expressions(stock.size()), Expressions(stock.size()), {}};
    auto& step_flows = flows.emplace_back();
    for (const auto& arc : arcs) {
      if (is_zero(stock[arc.from])) {
        continue;
      }
      const Variable amount = program_.add_variable({name, k, arc.from, arc.to});
      step_flows.push_back({arc, amount});
      sent.out[arc.from] += amount;
      sent.in[arc.to] += amount;
      sent.km.add(arc.km, amount);
    }
    return sent;
  }

  // theta c_hat_i Z_i,    Z_i >= (Y_i + eps)^(-a),    theta = theta_0 / a,    where points work
  void utilisation(int k, int i, Variable Y) {
    const double theta = p_.theta_0 / p_.a;
    const double c_hat = model_.c_hat(i, k);
    if (theta == 0.0 || data_.points(i, k) <= 0.0 || (c_hat == 0.0 && model_.supply_radius == 0.0)) {
      return;
    }
    const auto power = inverse_power(p_.eps, p_.a);
    utilised_.push_back({k * N_ + i, program_.minimise_curve("utilisation", theta * c_hat, Y, power, {"Z", k, i})});
  }

  // cost: omega sum_i (Y_i - u_i) + pi_e sum_i (c_low_i - e_i)
  void charge(int k, const Expressions& B, Step& step) {
    for (int i = 0; i < N_; ++i) {
      const Expression e = release(k, i, B[i]);
      const Expression u =
          station_[i] ? plug_in(k, i, step.Y[i], data_.points(i, k) - B[i] - topped_up(i, k < session_) + e) : 0.0;
      program_.minimise("queue", p_.omega * (step.Y[i] - u));
      program_.minimise("release", p_.pi_e * (model_.c_low(i, k) - e));
      step.e.push_back(e);
      step.u.push_back(u);
    }
  }

  // e_i <= B_i,    e_i <= c_low_i
  Expression release(int k, int i, const Expression& B) {
    const bool is_known = B.terms().empty();
    const double c_low = model_.c_low(i, k);
    const double most = is_known ? std::min(c_low, B.constant()) : c_low;
    if (most == 0.0) {
      return 0.0;
    }
    const Variable e = program_.add_variable({"e", k, i}, 0.0, most);
    if (!is_known) {
      program_.add(e <= B, {"released", k, i});
    }
    return e;
  }

  // u_i <= Y_i,    u_i <= P_i - B_i - t_i + e_i + z_i,    cost: z above any gain from u
  Expression plug_in(int k, int i, const Expression& Y, Expression free_points) {
    constexpr double z_price = 1000.0;
    if (data_.points(i, k) < data_.state.plugged(i)) {
      const Variable z = program_.add_variable({"z", k, i});
      program_.penalise(z_price * z);
      free_points += z;
    }
    const Variable u = program_.add_variable({"u", k, i});
    program_.add(u <= Y, {"plugged in", k, i});
    program_.add(u <= free_points, {"points", k, i});
    return u;
  }

  // theta sqrt(g) || Sigma_c^(1/2) Z ||  over the whole horizon
  void worst_case_utilisation() {
    const double weight = p_.theta_0 / p_.a * model_.supply_radius;
    if (weight == 0.0 || utilised_.empty()) {
      return;
    }
    const auto& set = supply_of(p_, data_);
    const auto count = std::ssize(utilised_);
    NormTerm norm{weight, {}, Eigen::VectorXd(count), Eigen::MatrixXd(count, set.factors.cols())};
    for (Eigen::Index n = 0; n < count; ++n) {
      const auto& [entry, Z] = utilised_[n];
      norm.variables.push_back(Z.index);
      norm.deviation(n) = set.deviation(entry);
      norm.factors.row(n) = set.factors.row(entry);
    }
    program_.minimise_norm("utilisation", std::move(norm));
  }

  // V+_i = sum_j Pv_ji S_j + sum_j Qv_ji O_j + e_i          L+_i = Y_i - u_i + sum_j Pl_ji S_j
  // O+_i = sum_j Po_ji S_j + sum_j Qo_ji O_j                B+_i = B_i + u_i - e_i
  Stock next_stock(int k, const Stock& stock, const Step& step) {
    const auto& [Pv, Po, Pl, Qv, Qo] = data_.transitions[k];
    const auto& [S, Y, u, e] = step;
    Stock next;
    const bool come_back = k + 2 < tau_;  // occupied cars, within the horizon, as vacant
    for (int i = 0; i < N_; ++i) {
      Expression V = e[i];
      Expression L = Y[i] - u[i];
      Expression O;
      for (int j = 0; j < N_; ++j) {
        V.add(Pv(j, i), S[j]).add(Qv(j, i), stock.O[j]);
        L.add(Pl(j, i), S[j]);
        if (come_back) {
          O.add(Po(j, i), S[j]).add(Qo(j, i), stock.O[j]);
        }
      }
      next.O.push_back(come_back ? variable_for(O, {"O", k + 1, i}, {"O", k + 1, i}) : O);
      next.V.push_back(std::move(V));
      next.L.push_back(std::move(L));
      next.B.push_back(stock.B[i] + u[i] - e[i]);
    }
    return next;
  }

  // A variable that stands for an expression which is long, or used often; `row` is their equation.
  Variable variable_for(const Expression& expression, const Name& name, const Name& row) {
    const Variable variable = program_.add_variable(name, -ConvexProgram::infinity);
    program_.add(variable == expression, row);
    return variable;
  }

  struct Utilised {
    int entry = 0;  // in the stacked vector of completions
    Variable Z;
  };

  const BalancingParameters& p_;
  const PlanningData& data_;
  const FormulationOptions& options_;
  Formulation result_;
  ConvexProgram& program_ = result_.program;
  UncertaintyModel model_;
  ShortageTerms shortage_;
  int N_;
  int tau_;
  Expressions topped_up_;      // t
  int session_;                // steps for which they are away
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
  return {.vacant = flows_at(formulation.vacant, x),
          .low_battery = flows_at(formulation.low_battery, x),
          .top_up = flows_at({formulation.top_up}, x).front()};
}

}  // namespace evbal
