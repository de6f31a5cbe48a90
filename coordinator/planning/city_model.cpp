#include "coordinator/planning/city_model.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace evbal {
namespace {

/// The period that holds `minute`; the first before it starts.
template <class AnyPeriod>
const AnyPeriod& in_force(const std::vector<AnyPeriod>& periods, int minute) {
  EVBAL_EXPECT(!periods.empty(), "at least one period");
  const auto after = std::upper_bound(periods.begin(), periods.end(), minute,
                                      [](int value, const AnyPeriod& period) { return value < period.start; });
  return after == periods.begin() ? *after : *std::prev(after);
}

}  // namespace

DayKind CityModel::kind(const std::string& date) const {
  return day_kind(date, std::binary_search(holidays.begin(), holidays.end(), date));
}

const Transitions& CityModel::transitions_at(int minute) const {
  return in_force(periods, minute).transitions;
}

const std::vector<TripShare>& CityModel::trips_at(int minute) const {
  return in_force(trips, minute).shares;
}

double CityModel::car_value(DayKind kind, int region, double minute) const {
  const Eigen::MatrixXd& values = car_values[static_cast<std::size_t>(kind)];
  const auto at = [&](Eigen::Index step) { return step < values.cols() ? values(region, step) : 0.0; };
  const double steps = std::max(0.0, (minute - day_start) / step_minutes);
  const auto step = static_cast<Eigen::Index>(steps);
  return std::lerp(at(step), at(step + 1), steps - static_cast<double>(step));
}

}  // namespace evbal
