#pragma once

#include "agents/world/city.hpp"

#include <map>
#include <tuple>
#include <vector>

namespace evbal {

/// Trips of a day by step, origin and destination.
using DayTrips = std::map<std::tuple<int, int, int>, int>;

/// The demand of a city's days, of their trips.
std::vector<DemandDay> demand_days(const City& city, const std::vector<DayTrips>& trips);

}  // namespace evbal
