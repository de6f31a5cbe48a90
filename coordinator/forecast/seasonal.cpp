#include "coordinator/forecast/seasonal.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <chrono>
#include <string_view>

namespace evbal {
namespace {

int digits(std::string_view text, std::size_t at, std::size_t count) {
  int value = -1;
  const char* first = text.data() + at;
  const auto [end, code] = std::from_chars(first, first + count, value);
  return code == std::errc{} && end == first + count ? value : -1;
}

std::chrono::year_month_day calendar_day(const std::string& date) {
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
  throw bad_input("`" + date + "` is no date; write it as 2008-06-03");
}

}  // namespace

DayKind day_kind(const std::string& date, bool holiday) {
  const std::chrono::weekday weekday{std::chrono::sys_days{calendar_day(date)}};
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

Regressors regressors(const Deviations& deviations, const Eigen::VectorXd& mean) {
  return {count_scale(mean).asDiagonal() * deviations.own, mean * deviations.city.transpose()};
}

SeasonalForecaster::SeasonalForecaster(const SeasonalModel& model, DayKind kind, int start)
    : step_minutes_(model.step_minutes),
      mean_(model.mean[static_cast<std::size_t>(kind)]),
      own_(model.own),
      city_(model.city),
      start_(start) {}

Eigen::VectorXd SeasonalForecaster::seasonal(int from, int to) const {
  return window_sum(mean_, step_minutes_, start_ + from, start_ + to);
}

void SeasonalForecaster::observe(int minute, const Eigen::VectorXd& counts) {
  assert(counts.size() == mean_.rows());
  const int from = pieces_.empty() ? 0 : pieces_.back().to;
  assert(minute >= from);
  if (minute == from) {
    return;
  }
  pieces_.push_back({from, minute, counts});
  const int memory = seasonal_lags * step_minutes_;
  while (pieces_.front().to <= minute - memory) {
    pieces_.pop_front();
  }
}

Deviations SeasonalForecaster::deviations() const {
  Deviations out{Eigen::MatrixXd::Zero(mean_.rows(), seasonal_lags), Eigen::VectorXd::Zero(seasonal_lags)};
  const int now = pieces_.empty() ? 0 : pieces_.back().to;
  for (int lag = 0; lag < seasonal_lags; ++lag) {
    const int end = now - lag * step_minutes_;
    const int begin = end - step_minutes_;
    if (begin < 0) {
      break;
    }
    // A report that spans two windows is shared out evenly over its minutes.
    Eigen::VectorXd observed = Eigen::VectorXd::Zero(mean_.rows());
    for (const Piece& piece : pieces_) {
      const int overlap = std::min(end, piece.to) - std::max(begin, piece.from);
      if (overlap > 0) {
        observed += piece.counts * (static_cast<double>(overlap) / (piece.to - piece.from));
      }
    }
    const Eigen::VectorXd expected = seasonal(begin, end);
    const Eigen::VectorXd error = observed - expected;
    out.own.col(lag) = error.cwiseQuotient(count_scale(expected));
    out.city(lag) = error.sum() / std::max(1.0, expected.sum());
  }
  return out;
}

Eigen::MatrixXd SeasonalForecaster::forecast(int minute, int tau) const {
  assert(tau <= own_.cols());
  const Deviations deviations = this->deviations();
  Eigen::MatrixXd out(mean_.rows(), tau);
  for (int lead = 0; lead < tau; ++lead) {
    const int from = minute + lead * step_minutes_;
    const Eigen::VectorXd mean = seasonal(from, from + step_minutes_);
    const Regressors x = regressors(deviations, mean);
    out.col(lead) = (mean + x.own * own_.col(lead) + x.city * city_.col(lead)).cwiseMax(0.0);
  }
  return out;
}

Eigen::MatrixXd SeasonalForecaster::scale(int minute, int tau) const {
  Eigen::MatrixXd out(mean_.rows(), tau);
  for (int lead = 0; lead < tau; ++lead) {
    const int from = minute + lead * step_minutes_;
    out.col(lead) = count_scale(seasonal(from, from + step_minutes_));
  }
  return out;
}

}  // namespace evbal
