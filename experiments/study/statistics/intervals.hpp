#pragma once

#include <string>
#include <vector>

/// How sure a mean over days is (docs/sweeps.md). Days are the unit: seeds of one day share
/// its demand, so they are averaged first, and it is the days' means that vary.
namespace evbal {

/// A number from one day with one seed.
struct DayValue {
  /// ISO 8601.
  std::string day;
  double value = 0.0;  ///< on that day
};

/// A mean and its 95 % interval, which is infinite where it is not known: with fewer than two days, or if all days
/// agree to the last digit on something else than 0, which says nothing of how days vary.
struct Interval {
  double mean = 0.0;  ///< of the days' means
  double low = 0.0;   ///< lower end
  double high = 0.0;  ///< upper end
};

/// Whether it is known.
bool is_known(const Interval& interval);

/// By Student's t on the days' means: right for few days if their means are about normal. `values` is not empty.
Interval t_interval(const std::vector<DayValue>& values);

/// The p value of Student's t test, two-sided, that the days' means are 0 in the mean; 1 where the interval is not
/// known. `values` is not empty.
double t_test(const std::vector<DayValue>& values);

/// p values of one family as Holm adjusts them: to call those below 0.05 shown is wrong, in one of them or more, with
/// probability 0.05 at most.
std::vector<double> holm(const std::vector<double>& p);

/// The t with P(|T| <= t) = `probability`, in (0, 1), for `degrees` >= 1 degrees of freedom.
double student_t(double probability, int degrees);

}  // namespace evbal
