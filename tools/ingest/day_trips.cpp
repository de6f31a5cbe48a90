#include "tools/ingest/day_trips.hpp"

#include <algorithm>

namespace evbal {

std::vector<DemandDay> demand_days(const City& city, const std::vector<DayTrips>& trips) {
  std::vector<DemandDay> days;
  for (std::size_t d = 0; d < trips.size(); ++d) {
    const bool holiday = std::binary_search(city.holidays.begin(), city.holidays.end(), city.days[d]);
    DemandDay& day = days.emplace_back(DemandDay{city.days[d], holiday, {}});
    day.steps.resize(city.steps_per_day());
    for (const auto& [key, count] : trips[d]) {
      const auto& [step, origin, destination] = key;
      day.steps[step].push_back({origin, destination, count});
    }
  }
  return days;
}

}  // namespace evbal
