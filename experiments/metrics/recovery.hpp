#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

/// What faults cost: a day beside the same day, seed and controller without them (docs/metrics.md, "What faults cost").
namespace evbal {

/// When a fault acts, in minutes since the day's start.
struct FaultWindow {
  int start = 0;  ///< minute
  int end = 0;    ///< may lie beyond the day
};

/// A metric's value in each step of both days. `with` and `without` are as long.
struct PairedCurves {
  std::span<const double> with;     ///< with faults, by step
  std::span<const double> without;  ///< without faults, by step
  int step_minutes = 0;             ///< length of a step
};

/// How one metric of a day with faults stands to the same day without them.
struct FaultCost {
  double with = 0.0;                           ///< over the day: sum over the steps, of stocks the mean
  double without = 0.0;                        ///< likewise
  double area = 0.0;                           ///< between the curves: value x hours
  double signed_area = 0.0;                    ///< likewise, of `with` less `without`
  double band = 0.0;                           ///< how far from the curve without faults still counts as back
  std::optional<int> recovered{};              ///< minutes from the end of the last fault until the curve is back
  std::vector<std::optional<int>> by_fault{};  ///< of each fault, in the order of the windows

  /// Of the faults, in units of the metric.
  double cost() const { return with - without; }
};

/// A metric of which costs are told: a column of steps.csv.
struct CostedMetric {
  std::string name;    ///< of the metric
  bool stock = false;  ///< how things stand at a step's end; else it adds up over steps
};

/// All of these, in the order in which they are shown.
const std::vector<CostedMetric>& costed_metrics();

/// Compares both curves. A curve has recovered at the first step, not before the fault ends, after which it stays
/// within `band` of the curve without faults for two hours (less if the next fault begins or the day ends); `band` is a
/// quarter of the greatest value of the curve without faults. Empty if there is no such step, or if the fault outlasts
/// the day.
FaultCost fault_cost(const PairedCurves& curves, bool stock, std::span<const FaultWindow> faults);

}  // namespace evbal
