#pragma once

#include "common/eigen.hpp"
#include "coordinator/forecast/arma.hpp"
#include "coordinator/forecast/forecaster.hpp"

#include <array>
#include <string>
#include <vector>

namespace evbal {

/// Days that resemble each other.
enum class DayKind {
  weekday = 0,
  saturday = 1,
  sunday = 2,  ///< and public holidays
};
/// Number of DayKind.
inline constexpr int day_kinds = 3;

/// Whether `text` is an ISO date ("2008-06-03") of the Gregorian calendar.
bool is_date(const std::string& text);

/// Kind of an ISO date ("2008-06-03") by the Gregorian calendar; a holiday is like a Sunday.
/// Throws Error{bad_input} if `date` is none.
DayKind day_kind(const std::string& date, bool holiday);

/// Counts per region and step of a day, and how deviations from them last. With m the seasonal mean of a region and
/// step, M its sum over the city, and x, X what was observed,
///     C = (X - M) / sqrt(M)    of the city   and    w = (x - m X / M) / s,  s = sqrt(m + 1/4),  of a region
/// are autoregressive moving averages that start anew each day. The forecast of lead k is  m (1 + C_k / sqrt(M)) + s
/// w_k.
struct SeasonalModel {
  int step_minutes = 30;                        ///< of the means
  std::array<Eigen::MatrixXd, day_kinds> mean;  ///< by DayKind, N x steps of the day
  ArmaModel city;                               ///< of C
  std::vector<ArmaModel> region;                ///< of w, N

  /// Number of regions.
  int regions() const { return static_cast<int>(mean[0].rows()); }
};

/// Sum of `mean` (N x steps) over the minutes [from, to) since the day's start, steps cut by the ends counted in part;
/// nothing outside the day.
Eigen::VectorXd window_sum(const Eigen::MatrixXd& mean, int step_minutes, int from, int to);

/// s = sqrt(m + 1/4), as in SeasonalModel.
Eigen::VectorXd count_scale(const Eigen::VectorXd& mean);

/// C and w of one window, as in SeasonalModel; NaN where nothing was observed.
struct Deviation {
  double city = 0.0;       ///< of the city's total
  Eigen::VectorXd region;  ///< of each region's share
};
/// How the counts of one window deviate from their seasonal mean; both N.
Deviation deviation(const Eigen::VectorXd& observed, const Eigen::VectorXd& mean);

/// Seasonal mean with an autoregressive correction, on one day.
class SeasonalForecaster : public Forecaster {
 public:
  /// `start` is the minute of the model's day at which this day starts.
  SeasonalForecaster(const SeasonalModel& model, DayKind kind, int start = 0);

  void observe(int minute, const Eigen::VectorXd& counts) override;
  Eigen::MatrixXd forecast(int minute, int tau) const override;
  Eigen::MatrixXd scale(int minute, int tau) const override;
  NormalisedInnovation normalised_innovation(int minute) const override;

  /// The forecast, and what variance the model gives its errors.
  struct Prediction {
    Eigen::MatrixXd mean;                        ///< N x tau
    Eigen::MatrixXd variance;                    ///< N x tau
    Eigen::VectorXd city_variance;               ///< of the sum over all regions, tau
    NormalisedInnovation normalised_innovation;  ///< of the last steps
  };
  /// The counts of `tau` steps from `minute` on.
  Prediction predict(int minute, int tau) const;

  /// Seasonal mean of the minutes [from, to), N.
  Eigen::VectorXd seasonal(int from, int to) const;

 private:
  struct Piece {
    int from = 0;
    int to = 0;
    Eigen::VectorXd counts;
  };

  Deviation seen(int from, int to) const;
  Eigen::VectorXd scale_of(int from) const;

  int step_minutes_;
  Eigen::MatrixXd mean_;  ///< of the day's kind
  ArmaFilter city_;
  std::vector<ArmaFilter> region_;
  int start_;
  std::vector<Piece> pieces_;
};

}  // namespace evbal
