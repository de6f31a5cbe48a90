#pragma once

#include "coordinator/forecast/forecaster.hpp"

#include <Eigen/Core>

#include <array>
#include <deque>
#include <string>
#include <vector>

namespace evbal {

/// Days that resemble each other.
enum class DayKind {
  weekday = 0,
  saturday = 1,
  sunday = 2,  ///< and public holidays
};
inline constexpr int day_kinds = 3;

/// Steps that a SeasonalModel looks back.
inline constexpr int seasonal_lags = 3;

/// Kind of an ISO date ("2008-06-03") by the Gregorian calendar; a holiday is like a Sunday.
/// Throws Error{bad_input} if `date` is none.
DayKind day_kind(const std::string& date, bool holiday);

/// Counts per region and step of a day, and how far deviations from them last. The forecast of lead k is
///     m_k + s_k sum_l own(l, k) u_l + m_k sum_l city(l, k) E_l,
/// with m the seasonal mean, s = sqrt(m + 1/4) the scale, u_l = (observed - m) / s of the region and
/// E_l = sum(observed - m) / sum m of the whole city in the l-th step back.
struct SeasonalModel {
  int step_minutes = 30;
  std::array<Eigen::MatrixXd, day_kinds> mean;  ///< by DayKind, N x steps of the day
  Eigen::MatrixXd own;                          ///< seasonal_lags x leads
  Eigen::MatrixXd city;                         ///< seasonal_lags x leads

  int regions() const { return static_cast<int>(mean[0].rows()); }
  int leads() const { return static_cast<int>(own.cols()); }
};

/// Sum of `mean` (N x steps) over the minutes [from, to) since the day's start, steps cut by the ends counted in part;
/// nothing outside the day.
Eigen::VectorXd window_sum(const Eigen::MatrixXd& mean, int step_minutes, int from, int to);

/// s = sqrt(m + 1/4), as in SeasonalModel.
Eigen::VectorXd count_scale(const Eigen::VectorXd& mean);

/// Deviations of what was observed from the seasonal mean, newest step first (SeasonalModel).
struct Deviations {
  Eigen::MatrixXd own;   ///< u, N x seasonal_lags
  Eigen::VectorXd city;  ///< E, seasonal_lags
};

/// The two parts of the correction at one lead, in counts: s u_l (N x lags) and m E_l (N x lags).
struct Regressors {
  Eigen::MatrixXd own;
  Eigen::MatrixXd city;
};
Regressors regressors(const Deviations& deviations, const Eigen::VectorXd& mean);

/// Seasonal mean with an autoregressive correction, on one day.
class SeasonalForecaster : public Forecaster {
 public:
  /// `start` is the minute of the model's day at which this day starts.
  SeasonalForecaster(const SeasonalModel& model, DayKind kind, int start = 0);

  void observe(int minute, const Eigen::VectorXd& counts) override;
  Eigen::MatrixXd forecast(int minute, int tau) const override;
  Eigen::MatrixXd scale(int minute, int tau) const override;

  Deviations deviations() const;

  /// Seasonal mean of the minutes [from, to), N.
  Eigen::VectorXd seasonal(int from, int to) const;

 private:
  struct Piece {
    int from = 0;
    int to = 0;
    Eigen::VectorXd counts;
  };

  int step_minutes_;
  Eigen::MatrixXd mean_;  ///< of the day's kind
  Eigen::MatrixXd own_;
  Eigen::MatrixXd city_;
  int start_;
  std::deque<Piece> pieces_;
};

}  // namespace evbal
