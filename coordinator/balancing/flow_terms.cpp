#include "coordinator/balancing/flow_terms.hpp"

#include "coordinator/balancing/cumulative_demand.hpp"
#include "coordinator/balancing/hinges.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

// Writes down the problem that stands on top of flow_terms.hpp.
class FlowFormulator {
 public:
  FlowFormulator(const BalancingParameters& parameters, const PlanningData& data, Uncertainty demand,
                 ConvexProgram& program)
      : p_(parameters),
        data_(data),
        uncertainty_(demand),
        demand_(data),
        program_(program),
        N_(static_cast<int>(data.km.rows())),
        K_(static_cast<int>(data.freed.mean.cols())),
        in_(K_, Expressions(N_)),
        out_(K_, Expressions(N_)),
        theta_(data.worth.vacant.size() == 0 ? 0.0 : parameters.flow_value),
        end_((1.0 - theta_) * parameters.flow_end),
        lambda_(weighted(data.worth.vacant)),
        mu_(weighted(data.worth.serving)) {}

  std::vector<ArcFlow> formulate(const std::vector<ArcFlow>& top_ups) {
    const int back = slot_of(data_.mean_session_minutes / p_.flow_slot);
    for (const auto& [arc, amount] : top_ups) {
      out_[0][arc.from] += amount;
      if (back < K_) {
        in_[back][arc.from] += amount;
      }
    }
    const std::vector<Arc> arcs = vacant_arcs(data_.km, p_.flow_m1, p_.flow_neighbours);
    std::vector<ArcFlow> now;
    Expression km;
    for (int m = 0; m < std::min(p_.flow_sends, K_); ++m) {
      const std::vector<ArcFlow> sent = send(m, arcs);
      for (const auto& [arc, amount] : sent) {
        km.add(arc.km, amount);
      }
      now = m == 0 ? sent : now;
    }
    program_.minimise("km", km);
    for (int i = 0; i < N_; ++i) {
      have(i);
    }
    return now;
  }

 private:
  // One variable for each arc that leaves a region with cars and ends within the slots.
  std::vector<ArcFlow> send(int m, const std::vector<Arc>& arcs) {
    std::vector<ArcFlow> sent;
    for (const Arc& arc : arcs) {
      const double there = data_.state.vacant(arc.from) + freed(arc.from, m - 1);
      const int arrives = arrival_slot(m, arc);
      if (there <= 0.0 || arrives >= K_) {
        continue;
      }
      const Variable amount = program_.add_variable({"x", m, arc.from, arc.to});
      sent.push_back({arc, amount});
      out_[m][arc.from] += amount;
      in_[arrives][arc.to] += amount;
    }
    return sent;
  }

  // The slot by whose end a car is there that sets off at the start of slot m; K if none is.
  int arrival_slot(int m, const Arc& arc) const {
    return std::max(m, slot_of(m + std::ceil(data_.minutes(arc.from, arc.to)) / p_.flow_slot));
  }

  // The slot by whose end so many slots have passed; K if none is.
  int slot_of(double slots) const { return slots > K_ ? K_ : std::max(0, static_cast<int>(std::ceil(slots)) - 1); }

  double freed(int i, int k) const { return k < 0 ? 0.0 : data_.freed.mean(i, k); }

  // C_i(k) = C_i(k-1) + freed_i(k) - freed_i(k-1) + in_i(k) - out_i(k),      out_i(k) <= C_i(k-1)
  void have(int i) {
    Expression C = data_.state.vacant(i);
    for (int k = 0; k < K_; ++k) {
      if (!out_[k][i].terms().empty()) {
        program_.add(out_[k][i] <= C, {"set off", k, i});
      }
      C += freed(i, k) - freed(i, k - 1);
      C += in_[k][i];
      C -= out_[k][i];
      C = minimise_hinges(program_, C, missed(k, i), {"cars", k, i});
    }
    if (const double most = lambda_.maxCoeff(); most > 0.0) {
      program_.minimise("worth", (most - lambda_(i)) * C);
    }
  }

  // p_ik E[(N_i(k) - C)_+]: a hinge of C for each value of N_i(k)
  std::vector<Hinge> missed(int k, int i) const {
    const DiscreteDistribution N = passengers(k, i);
    std::vector<Hinge> hinges;
    for (std::size_t m = 0; m < N.values.size(); ++m) {
      hinges.push_back({"shortage", -price(k, i) * N.probabilities[m], N.values[m]});
    }
    return hinges;
  }

  // p_ik
  double price(int k, int i) const {
    const bool last = k + 1 == K_;
    const double price = p_.p_flow * ((1.0 - end_) / K_ + (last ? end_ : 0.0));
    return last ? std::max(0.0, price + mu_(i) - lambda_(i)) : price;
  }

  // theta times a worth
  Eigen::VectorXd weighted(const Eigen::VectorXd& worth) const {
    return worth.size() == 0 ? Eigen::VectorXd(Eigen::VectorXd::Zero(N_)) : Eigen::VectorXd(theta_ * worth);
  }

  // N_i(k)
  DiscreteDistribution passengers(int k, int i) const {
    constexpr double least = 1.0 / 16.0;  // of the probability, for each of its values: few parts of C
    const double mean = demand_.within(std::max(0.0, (k + 1) * p_.flow_slot - p_.flow_patience), i);
    const auto step = static_cast<Eigen::Index>(k * p_.flow_slot / data_.step_minutes);
    const double variance = data_.turnover.demand.at(step, mean) + data_.freed.variance(i, k);
    return uncertainty_ == Uncertainty::mean ? certain(mean) : negative_binomial(mean, variance, least);
  }

  const BalancingParameters& p_;
  const PlanningData& data_;
  Uncertainty uncertainty_;
  CumulativeDemand demand_;
  ConvexProgram& program_;
  int N_;
  int K_;
  std::vector<Expressions> in_;   // by slot and region
  std::vector<Expressions> out_;  // likewise
  double theta_;                  // flow_value; 0 where no worth is known
  double end_;                    // (1 - theta) flow_end
  Eigen::VectorXd lambda_;        // theta lambda_i
  Eigen::VectorXd mu_;            // theta mu_i
};

}  // namespace

std::vector<ArcFlow> add_flow(const BalancingParameters& parameters, const PlanningData& data, Uncertainty demand,
                              const std::vector<ArcFlow>& top_ups, ConvexProgram& program) {
  return FlowFormulator(parameters, data, demand, program).formulate(top_ups);
}

}  // namespace evbal
