#pragma once

#include "experiments/study/design/page.hpp"
#include "experiments/study/statistics/comparison.hpp"
#include "experiments/study/statistics/front.hpp"

#include <string>
#include <vector>

namespace evbal {

/// The days that a page is made from.
struct PageDays {
  std::vector<FinishedDay> days;      ///< with the page's objective
  std::vector<FinishedDay> bounds{};  ///< corners of what is the least on a day, as days of the variant `bound`
};

/// The variants' whole fronts, or settings where there is only one, against the reference on the scenarios and
/// schedules of faults that are named; of lost passengers at equal idle km with the share of the way to the bound,
/// where it is known.
std::vector<Compared> whole_rows(const PageDays& days, const std::vector<std::string>& variants,
                                 const Question& question, const std::vector<std::string>& scenarios,
                                 const std::vector<std::string>& faults);

/// The least that is possible in one scenario under one schedule of faults: the mean over days of the mean over those
/// of their seeds for which it is known.
struct MeanBound {
  std::vector<FrontPoint> front{};  ///< lost passengers by idle km; empty unless it is known for each day
  int days = 0;                     ///< for which it is known
  int of_days = 0;                  ///< that were played
  int seeds = 0;                    ///< days with each seed for which it is known
  int of_seeds = 0;                 ///< that were played
};

/// The bound of one scenario and schedule of faults.
MeanBound mean_bound(const PageDays& days, const std::string& scenario, const std::string& faults);

/// A metric's mean over days, of which there is one at least, with its interval.
Interval mean_over_days(const std::vector<const FinishedDay*>& days, const std::string& metric);

/// Whether a variant has several settings in one of its scenarios.
bool has_front(const std::vector<FinishedDay>& days, const std::string& variant);

}  // namespace evbal
