#pragma once

#include "coordinator/balancing/arcs.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/balancing/send_limits.hpp"
#include "coordinator/balancing/top_up.hpp"
#include "coordinator/balancing/uncertainty_model.hpp"
#include "coordinator/convex/convex_program.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace evbal {

/// The problem of docs/model.md, section 2, letter by letter, for the bands and `turnover`: a variable for every
/// quantity, whether it is zero or not, and a row for every relation.
struct PlainFormulation {
  PlainFormulation(const BalancingParameters& parameters, const PlanningData& known_data,
                   const FormulationOptions& options)
      : p(parameters),
        data(known_data),
        turnover(options.shortage == Shortage::turnover),
        model(uncertainty_model(parameters, data, options)),
        N(static_cast<int>(data.km.rows())),
        tau(static_cast<int>(data.points.cols())),
        rho(demand_per_vehicle(data, model)) {
    for (int i = 0; i < N; ++i) {
      C.push_back(data.points.row(i).maxCoeff() > 0.0);
    }
    const auto& now = data.state;
    Variables V = known(now.vacant);
    Variables O = known(now.occupied);
    Variables L = known(now.low_battery);
    Variables B = known(now.plugged);
    const Variables t = topped_up();
    const int session = static_cast<int>(std::ceil(data.mean_session_minutes / data.step_minutes));
    for (int k = 0; k < tau; ++k) {
      std::vector<Expression> come(N), come_low(N), leave(N), stay(N), points(N);
      for (int i = 0; i < N; ++i) {
        come[i] = now.arriving_vacant(i, k) + (k == session ? 1.0 : 0.0) * t[i];
        come_low[i] = now.arriving_low_battery(i, k);
        leave[i] = (k == 0 ? 1.0 : 0.0) * t[i];
        points[i] = data.points(i, k) - (k < session ? 1.0 : 0.0) * t[i];
      }
      const Variables S = sent(vacant_arcs(data.km, p.m1, p.neighbours), V, come, leave, 1.0);
      const Variables Y = sent(low_battery_arcs(data.km, C, p.m2, p.neighbours), L, come_low, stay, p.beta, k == 0);
      const Variables u = program.add_block("u", N);
      const Variables e = program.add_block("e", N);
      charge(k, points, B, Y, u, e);
      const auto& [Pv, Po, Pl, Qv, Qo] = data.transitions[k];
      const Variables next[] = {any(), any(), any(), any()};
      for (int i = 0; i < N; ++i) {
        shortage(k, i, S[i]);
        Expression v = e[i];
        Expression l = Y[i] - u[i];
        Expression o;
        for (int j = 0; j < N; ++j) {
          v += Pv(j, i) * S[j] + Qv(j, i) * O[j];
          o += Po(j, i) * S[j] + Qo(j, i) * O[j];
          l += Pl(j, i) * S[j];
        }
        program.add(next[0][i] == v);
        program.add(next[1][i] == o);
        program.add(next[2][i] == l);
        program.add(next[3][i] == B[i] + u[i] - e[i]);
      }
      V = next[0];
      O = next[1];
      L = next[2];
      B = next[3];
    }
  }

  Variables any() { return program.add_block("stock", N, -ConvexProgram::infinity); }

  Variables known(const Eigen::VectorXd& vehicles) {
    const Variables variables = any();
    for (int i = 0; i < N; ++i) {
      program.bound(variables[i], vehicles(i), vehicles(i));
    }
    return variables;
  }

  Variables topped_up() {
    const Variables t = program.add_block("t", N);
    const Eigen::VectorXd T = top_up_room(data);
    for (int i = 0; i < N; ++i) {
      program.bound(t[i], 0.0, T(i));
      program.minimise("top-up", p.top_up * (T(i) - t[i]));
    }
    return t;
  }

  // S_i = V_i + come_i - leave_i + in - out,  leave_i + out <= V_i;  no more go a distance than get so far
  Variables sent(const std::vector<Arc>& arcs, const Variables& V, const std::vector<Expression>& come,
                 const std::vector<Expression>& leave, double price, bool within_reach = false) {
    const Variables S = any();
    std::vector<Expression> in(V.size());
    std::vector<Expression> out(V.size());
    std::vector<Expression> far(arcs.size());
    for (const auto& [from, to, km] : arcs) {
      const Variable x = program.add_variable("x");
      for (std::size_t a = 0; a < arcs.size(); ++a) {
        far[a].add(arcs[a].from == from && arcs[a].km <= km ? 1.0 : 0.0, x);
      }
      in[to] += x;
      out[from] += x;
      program.minimise("km", price * km * x);
    }
    for (int i = 0; i < N; ++i) {
      program.add(S[i] == V[i] + come[i] - leave[i] + in[i] - out[i]);
      program.add(leave[i] + out[i] <= V[i]);
    }
    for (std::size_t a = 0; within_reach && a < arcs.size(); ++a) {
      program.add(far[a] <= low_battery_reaching(data.state, arcs[a].from, arcs[a].km));
    }
    return S;
  }

  void charge(int k, const std::vector<Expression>& points, const Variables& B, const Variables& Y, const Variables& u,
              const Variables& e) {
    const Variables z = program.add_block("z", N);
    for (int i = 0; i < N; ++i) {
      program.add(u[i] <= Y[i]);
      program.add(u[i] <= (C[i] ? points[i] - B[i] + e[i] + z[i] : Expression(0.0)));
      program.add(e[i] <= B[i]);
      program.add(e[i] <= model.c_low(i, k));
      program.minimise("charging", p.omega * (Y[i] - u[i]) + p.pi_e * (model.c_low(i, k) - e[i]));
      program.penalise(1000.0 * z[i]);
      if (p.theta_0 > 0.0 && data.points(i, k) > 0.0 && model.c_hat(i, k) > 0.0) {
        program.minimise_curve("utilisation", p.theta_0 / p.a * model.c_hat(i, k), Y[i], inverse_power(p.eps, p.a),
                               "Z");
      }
    }
  }

  void shortage(int k, int i, Variable S) {
    const double h = turnover ? 1.0 : rho(k) * (1.0 + p.eta);
    const double l = rho(k) * (1.0 - p.eta);
    const int entry = k * N + i;
    const auto& r = model.shortage[entry];
    for (std::size_t m = 0; m < r.values.size(); ++m) {
      const Variable missing = program.add_variable("missing");
      program.add(missing >= r.values[m] - h * S - model.serving_again(i, k));
      program.minimise("shortage", p.p_shortage * r.probabilities[m] * missing);
    }
    if (!turnover) {
      const auto& r_low = model.surplus[entry];
      for (std::size_t m = 0; m < r_low.values.size(); ++m) {
        const Variable idle = program.add_variable("idle");
        program.add(idle >= l * S - r_low.values[m]);
        program.minimise("surplus", p.p_surplus * r_low.probabilities[m] * idle);
      }
    }
  }

  ConvexProgram program;
  const BalancingParameters& p;
  const PlanningData& data;
  bool turnover;
  UncertaintyModel model;
  int N;
  int tau;
  Eigen::VectorXd rho;
  std::vector<bool> C;
};

}  // namespace evbal
