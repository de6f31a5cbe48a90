#pragma once

#include "coordinator/balancing/problem.hpp"
#include "coordinator/balancing/uncertainty_model.hpp"
#include "coordinator/convex/convex_program.hpp"

namespace evbal {

/// The price of too few vehicles in the regions, the cost term "shortage", and of too many, "surplus": what sets the
/// controllers apart (docs/model.md, sections 3 and 4). FormulationOptions::shortage chooses the form.
class ShortageTerms {
 public:
  /// Everything given must outlive this.
  ShortageTerms(const BalancingParameters& parameters, const PlanningData& data, const FormulationOptions& options,
                const UncertaintyModel& model, ConvexProgram& program);

  /// Adds the terms of step k to the program; `S` are the vacant vehicles of every region after dispatch.
  void add(int k, const Variables& S);

 private:
  double h(int k) const;
  double l(int k) const;
  void band(int k, const Variables& S);
  void moments(int k, const Variables& S);
  void ratio(int k, const Variables& S);
  void turnover(int k, const Variables& S);
  void curve(const Name& name, double price, Variable of, const ConvexFunctionPtr& function);

  const BalancingParameters& p_;
  const PlanningData& data_;
  const FormulationOptions& options_;
  const UncertaintyModel& model_;
  ConvexProgram& program_;
  Eigen::VectorXd rho_;
};

}  // namespace evbal
