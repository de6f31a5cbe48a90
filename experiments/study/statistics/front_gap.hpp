#pragma once

#include "experiments/study/statistics/front.hpp"

#include <optional>
#include <vector>

namespace evbal {

/// How two fronts lie to each other over the costs that both cover.
struct FrontGap {
  double from = 0.0;       ///< cost
  double to = 0.0;         ///< cost, above `from`, or equal if one of the two is a frozen setting
  double value = 0.0;      ///< mean
  double reference = 0.0;  ///< mean
  double covered = 0.0;    ///< share of the reference's costs
};

/// The gap between two fronts, exactly, as both are made of straight lines: points of rising cost. Nothing if they have
/// no range of costs in common. `frozen`: one of them is a single setting, which is held against the other at its own
/// cost.
std::optional<FrontGap> front_gap(const std::vector<FrontPoint>& front, const std::vector<FrontPoint>& reference,
                                  bool frozen = false);

/// The mean of ln((value + 1/2) / (reference + 1/2)) over the gap's costs. No value is negative.
double mean_log_ratio(const std::vector<FrontPoint>& front, const std::vector<FrontPoint>& reference,
                      const FrontGap& gap);

/// The mean of a front from one cost to another, which it covers; its value there if they are the same.
double mean_value(const std::vector<FrontPoint>& front, double from, double to);

}  // namespace evbal
