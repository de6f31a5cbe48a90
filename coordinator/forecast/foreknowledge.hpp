#pragma once

#include "coordinator/forecast/forecaster.hpp"

namespace evbal {

/// Gives the true counts as the forecast: for controllers that show what better forecasts could bring at most.
class Foreknowledge : public Forecaster {
 public:
  /// `counts` of every region in each tick of the day, N x ticks; a step of `step` minutes is made of whole ticks.
  Foreknowledge(Eigen::MatrixXd counts, int tick, int step);

  void observe(int minute, const Eigen::VectorXd& counts) override;
  Eigen::MatrixXd forecast(int minute, int tau) const override;

  /// Nothing: there are no errors.
  Eigen::MatrixXd scale(int minute, int tau) const override;

  /// None.
  NormalisedInnovation normalised_innovation(int minute) const override;

 private:
  Eigen::MatrixXd counts_;
  int tick_;
  int step_;
};

}  // namespace evbal
