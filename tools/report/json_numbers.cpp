#include "tools/report/json_numbers.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace evbal {

nlohmann::ordered_json rounded_json(double value) {
  if (value == 0.0 || !std::isfinite(value)) {
    return value == 0.0 ? nlohmann::ordered_json(0) : nlohmann::ordered_json(nullptr);
  }
  const double scale = std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

nlohmann::ordered_json interval_json(const Interval& interval) {
  return {rounded_json(interval.mean), rounded_json(interval.low), rounded_json(interval.high)};
}

nlohmann::ordered_json points_json(const std::vector<FrontPoint>& points) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const FrontPoint& point : points) {
    list.push_back({rounded_json(point.cost), rounded_json(point.value)});
  }
  return list;
}

}  // namespace evbal
