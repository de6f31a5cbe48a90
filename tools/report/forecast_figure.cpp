#include "tools/report/forecast_figure.hpp"

#include <cmath>

namespace evbal {

ForecastFigure forecast_figure(const SeasonalModel& model, DayKind kind, int start, const Eigen::MatrixXd& counts) {
  ForecastFigure figure;
  figure.step_minutes = model.step_minutes;
  figure.observed = counts.colwise().sum();
  figure.forecast.resize(counts.cols());
  figure.deviation.resize(counts.cols());
  SeasonalForecaster forecaster(model, kind, start);
  for (int step = 0; step < counts.cols(); ++step) {
    const int minute = step * model.step_minutes;
    const auto ahead = forecaster.predict(minute, 1);
    figure.forecast(step) = ahead.mean.sum();
    figure.deviation(step) = std::sqrt(ahead.city_variance(0));
    forecaster.observe(minute + model.step_minutes, counts.col(step));
  }
  return figure;
}

}  // namespace evbal
