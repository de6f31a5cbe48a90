#include "coordinator/planning/city_model.hpp"

#include "common/contract.hpp"

#include <algorithm>

namespace evbal {

DayKind CityModel::kind(const std::string& date) const {
  return day_kind(date, std::binary_search(holidays.begin(), holidays.end(), date));
}

const Transitions& CityModel::transitions_at(int minute) const {
  EVBAL_EXPECT(!periods.empty(), "at least one period");
  const auto after = std::upper_bound(periods.begin(), periods.end(), minute,
                                      [](int value, const Period& period) { return value < period.start; });
  return (after == periods.begin() ? after : std::prev(after))->transitions;
}

}  // namespace evbal
