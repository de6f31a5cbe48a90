#include "coordinator/forecast/seasonal.hpp"

#include "common/contract.hpp"
#include "common/error.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace evbal {
namespace {

int digits(std::string_view text, std::size_t at, std::size_t count) {
  int value = -1;
  const char* first = text.data() + at;
  const auto [end, code] = std::from_chars(first, first + count, value);
  return code == std::errc{} && end == first + count ? value : -1;
}

std::optional<std::chrono::year_month_day> calendar_day(const std::string& date) {
  using namespace std::chrono;
  if (date.size() == 10 && date[4] == '-' && date[7] == '-') {
    const int y = digits(date, 0, 4);
    const int m = digits(date, 5, 2);
    const int d = digits(date, 8, 2);
    if (y > 0 && m > 0 && d > 0) {
      const year_month_day day(year{y}, month{static_cast<unsigned>(m)}, std::chrono::day{static_cast<unsigned>(d)});
      if (day.ok()) {
        return day;
      }
    }
  }
  return {};
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// M, floored: of a city without counts, ratios to the mean say nothing.
double city_total(const Eigen::ArrayXd& mean) {
  return std::max(1.0, mean.sum());
}

constexpr int recent_steps = 3;

/// Mean of squared innovations over their variance, which is taken to be a Poisson count's at least: of a region with
/// few counts, a smaller variance was fitted to too little.
class MeanSquare {
 public:
  void add(const Innovation& innovation) {
    if (!std::isnan(innovation.value)) {
      sum_ += innovation.value * innovation.value / std::max(1.0, innovation.variance);
      ++count_;
    }
  }

  double value() const { return sum_ / std::max(1, count_); }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

}  // namespace

bool is_date(const std::string& text) {
  return calendar_day(text).has_value();
}

DayKind day_kind(const std::string& date, bool holiday) {
  const auto day = calendar_day(date);
  if (!day) {
    throw bad_input("`" + date + "` is no date; write it as 2008-06-03");
  }
  const std::chrono::weekday weekday{std::chrono::sys_days{*day}};
  if (holiday || weekday == std::chrono::Sunday) {
    return DayKind::sunday;
  }
  return weekday == std::chrono::Saturday ? DayKind::saturday : DayKind::weekday;
}

Eigen::VectorXd window_sum(const Eigen::MatrixXd& mean, int step_minutes, int from, int to) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(mean.rows());
  for (int step = 0; step < mean.cols(); ++step) {
    const int overlap = std::min(to, (step + 1) * step_minutes) - std::max(from, step * step_minutes);
    if (overlap > 0) {
      sum += mean.col(step) * (static_cast<double>(overlap) / step_minutes);
    }
  }
  return sum;
}

Eigen::VectorXd count_scale(const Eigen::VectorXd& mean) {
  return (mean.array() + 0.25).sqrt();
}

Deviation deviation(const Eigen::VectorXd& observed, const Eigen::VectorXd& mean) {
  const Eigen::Array<bool, Eigen::Dynamic, 1> known = observed.array() == observed.array();
  if (!known.any()) {
    return {unknown, Eigen::VectorXd::Constant(mean.size(), unknown)};
  }
  const double expected = city_total(known.select(mean.array(), 0.0));
  const double excess = known.select((observed - mean).array(), 0.0).sum();
  const Eigen::VectorXd share = mean * (1.0 + excess / expected);
  return {excess / std::sqrt(expected), (observed - share).cwiseQuotient(count_scale(mean))};
}

SeasonalForecaster::SeasonalForecaster(const SeasonalModel& model, DayKind kind, int start)
    : step_minutes_(model.step_minutes),
      mean_(model.mean[static_cast<std::size_t>(kind)]),
      city_(model.city),
      region_(model.region.begin(), model.region.end()),
      start_(start) {
  EVBAL_EXPECT(static_cast<Eigen::Index>(region_.size()) == mean_.rows(), "a model of each region that has a mean");
}

Eigen::VectorXd SeasonalForecaster::seasonal(int from, int to) const {
  return window_sum(mean_, step_minutes_, start_ + from, start_ + to);
}

void SeasonalForecaster::observe(int minute, const Eigen::VectorXd& counts) {
  EVBAL_EXPECT(counts.size() == mean_.rows(), "a count of every region");
  const int from = pieces_.empty() ? 0 : pieces_.back().to;
  EVBAL_EXPECT(minute >= from, "a time not before the last one");
  if (minute > from) {
    pieces_.push_back({from, minute, counts});
  }
}

/// What was seen of a window, against what was expected of the part seen; unknown where that is less than half.
Deviation SeasonalForecaster::seen(int from, int to) const {
  Eigen::VectorXd observed = Eigen::VectorXd::Zero(mean_.rows());
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(mean_.rows());
  Eigen::VectorXd minutes = Eigen::VectorXd::Zero(mean_.rows());
  for (const Piece& piece : pieces_) {
    const int begin = std::max(from, piece.from);
    const int end = std::min(to, piece.to);
    if (begin >= end) {
      continue;
    }
    // A report that spans two windows is shared out evenly over its minutes.
    const double share = static_cast<double>(end - begin) / (piece.to - piece.from);
    const Eigen::VectorXd mean = seasonal(begin, end);
    for (Eigen::Index i = 0; i < mean.size(); ++i) {
      if (!std::isnan(piece.counts(i))) {
        observed(i) += share * piece.counts(i);
        expected(i) += mean(i);
        minutes(i) += end - begin;
      }
    }
  }
  observed = (2.0 * minutes.array() >= to - from).select(observed, unknown);
  return deviation(observed, expected);
}

/// s of the step from `from` on, 0 if the day is over.
Eigen::VectorXd SeasonalForecaster::scale_of(int from) const {
  const bool over = start_ + from >= mean_.cols() * step_minutes_;
  return over ? Eigen::VectorXd::Zero(mean_.rows()) : count_scale(seasonal(from, from + step_minutes_));
}

SeasonalForecaster::Prediction SeasonalForecaster::predict(int minute, int tau) const {
  ArmaFilter city = city_;
  std::vector<ArmaFilter> regions = region_;
  MeanSquare city_square;
  std::vector<MeanSquare> squares(regions.size());
  for (int from = minute % step_minutes_; from < minute; from += step_minutes_) {
    const Deviation now = seen(from, from + step_minutes_);
    const bool recent = from >= minute - recent_steps * step_minutes_;
    const auto take = [recent](ArmaFilter& filter, double y, MeanSquare& square) {
      const Innovation innovation = filter.observe(y);
      if (recent) {
        square.add(innovation);
      }
    };
    take(city, now.city, city_square);
    for (std::size_t i = 0; i < regions.size(); ++i) {
      take(regions[i], now.region(static_cast<Eigen::Index>(i)), squares[i]);
    }
  }
  const Outlook city_ahead = city.outlook(tau);
  Prediction out{Eigen::MatrixXd::Zero(mean_.rows(), tau),
                 Eigen::MatrixXd::Zero(mean_.rows(), tau),
                 Eigen::VectorXd(tau),
                 {city_square.value(), Eigen::VectorXd(mean_.rows())}};
  for (Eigen::Index i = 0; i < mean_.rows(); ++i) {
    const Outlook ahead = regions[static_cast<std::size_t>(i)].outlook(tau);
    out.mean.row(i) = ahead.mean;
    out.variance.row(i) = ahead.variance;
    out.normalised_innovation.region(i) = squares[static_cast<std::size_t>(i)].value();
  }
  for (int lead = 0; lead < tau; ++lead) {
    const int from = minute + lead * step_minutes_;
    const Eigen::ArrayXd mean = seasonal(from, from + step_minutes_);
    const Eigen::ArrayXd scale = scale_of(from);
    const Eigen::ArrayXd share = mean / std::sqrt(city_total(mean));
    out.mean.col(lead) = mean + share * city_ahead.mean(lead) + scale * out.mean.col(lead).array();
    const Eigen::ArrayXd own = scale.square() * out.variance.col(lead).array();
    out.variance.col(lead) = share.square() * city_ahead.variance(lead) + own;
    out.city_variance(lead) = share.sum() * share.sum() * city_ahead.variance(lead) + own.sum();
  }
  out.mean = out.mean.cwiseMax(0.0);
  return out;
}

NormalisedInnovation SeasonalForecaster::normalised_innovation(int minute) const {
  return predict(minute, 1).normalised_innovation;
}

Eigen::MatrixXd SeasonalForecaster::forecast(int minute, int tau) const {
  return predict(minute, tau).mean;
}

Eigen::MatrixXd SeasonalForecaster::scale(int minute, int tau) const {
  Eigen::MatrixXd out(mean_.rows(), tau);
  for (int lead = 0; lead < tau; ++lead) {
    out.col(lead) = scale_of(minute + lead * step_minutes_);
  }
  return out;
}

}  // namespace evbal
