#pragma once

#include "experiments/study/statistics/intervals.hpp"

#include <string>
#include <vector>

/// Which of a schedule's faults did it (docs/faults.md): how the result of a draw goes with what was drawn.
namespace evbal {

/// Something about a fault that differs between draws.
struct DrawnQuantity {
  std::string fault;           ///< its name
  std::string quantity;        ///< such as "start"
  std::vector<double> values;  ///< of each draw; NaN in draws without the fault
};

/// How a metric goes with a quantity, over the draws that have one.
struct Influence {
  std::string fault;        ///< its name
  std::string quantity;     ///< as in DrawnQuantity
  int draws = 0;            ///< that were compared
  Interval correlation{};   ///< Spearman's rank correlation, with its 95 % interval by Bonett and Wright
  double p = 1.0;           ///< share of random orders of the draws whose correlation is as large, two-sided
  double p_adjusted = 1.0;  ///< the same as Holm adjusts it for all quantities
};

/// The influence of each quantity on `metric`, of which there is one value a draw; the strongest first. The interval is
/// not known for fewer than ten draws and for ranks that agree exactly.
std::vector<Influence> influences(const std::vector<DrawnQuantity>& quantities, const std::vector<double>& metric);

}  // namespace evbal
