#pragma once

#include "common/eigen.hpp"

namespace evbal {

/// Normalised innovation squared: the mean over the last steps of squared innovations (what came less what was expected
/// of it), each over its variance; about 1 while errors are as they were in training, 0 where nothing is known.
struct NormalisedInnovation {
  double city = 0.0;       ///< of the city's total
  Eigen::VectorXd region;  ///< N
};

/// Forecasts counts per region (passengers who appear, charging sessions that end) while a day goes on.
/// Minutes count from the day's start.
class Forecaster {
 public:
  virtual ~Forecaster() = default;

  /// Takes the counts (N) of the minutes from the last observation, or the day's start, up to `minute`; NaN where they
  /// are not known.
  virtual void observe(int minute, const Eigen::VectorXd& counts) = 0;

  /// Expected counts of the `tau` windows of one step each that follow `minute`, N x tau, none negative. Minutes after
  /// the day's end count nothing. `minute` is not before the last observation.
  virtual Eigen::MatrixXd forecast(int minute, int tau) const = 0;

  /// Size of an ordinary forecast error of the same windows, N x tau, 0 where there is none: residuals divided by it
  /// are alike at any time of the day (docs/model.md, section 5).
  virtual Eigen::MatrixXd scale(int minute, int tau) const = 0;

  /// Of the last three steps up to `minute`, the last observation's.
  virtual NormalisedInnovation normalised_innovation(int minute) const = 0;
};

}  // namespace evbal
