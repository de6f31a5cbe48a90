#pragma once

#include "common/eigen.hpp"

#include <array>
#include <memory>
#include <optional>

namespace evbal {

/// The cars that a stock filter counts, by position.
enum class CarKind { vacant = 0, occupied_due = 1, low_battery = 2, plugged = 3 };

/// How many stocks there are.
inline constexpr int stocks = 4;

/// Counts of a region's stocks, by CarKind.
using StockVector = Eigen::Matrix<double, stocks, 1>;
/// Covariances between them.
using StockMatrix = Eigen::Matrix<double, stocks, stocks>;

/// A Kalman filter of the cars of one region, for as long as not all of them can be taken from its reports: MRPT's
/// CKalmanFilterCapable without features. What comes and goes is its action; its observations are the counts that are
/// believed, and the number of cars here that is left if all other regions' and the road's are taken from the fleet.
class StockFilter {
 public:
  /// Starts from counts with independent errors.
  StockFilter(const StockVector& counts, const StockVector& variances);
  /// Moves; the one that is left may only be assigned to or end.
  StockFilter(StockFilter&&) noexcept;
  /// Moves, as above.
  StockFilter& operator=(StockFilter&&) noexcept;
  ~StockFilter();

  /// `change` is what is known to have come less what is known to have gone, `noise` the covariance of what is not.
  void predict(const StockVector& change, const StockMatrix& noise);

  /// Takes the counts that are believed, which are right but for a variance near zero.
  void observe(const std::array<std::optional<double>, stocks>& counts);

  /// Takes the number of vacant, low-battery and plugged cars together, which has this variance.
  void observe_total(double vehicles, double variance);

  /// The expected counts.
  StockVector counts() const;

  /// The covariances of their errors.
  StockMatrix covariance() const;

 private:
  class Kalman;
  std::unique_ptr<Kalman> kalman_;
};

/// Vacant, low-battery and plugged cars together.
double total(const StockVector& counts);

/// The variance of that total.
double total_variance(const StockMatrix& covariance);

}  // namespace evbal
