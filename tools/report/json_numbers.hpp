#pragma once

#include "experiments/study/statistics/front.hpp"
#include "experiments/study/statistics/intervals.hpp"

#include <nlohmann/json_fwd.hpp>

#include <vector>

/// Numbers as pages read them.
namespace evbal {

/// To six digits, which is more than a page shows; null for what is not finite.
nlohmann::ordered_json rounded_json(double value);

/// Mean, low and high.
nlohmann::ordered_json interval_json(const Interval& interval);

/// A list of cost and value of each point.
nlohmann::ordered_json points_json(const std::vector<FrontPoint>& points);

}  // namespace evbal
