#pragma once

#include "agents/world/city.hpp"
#include "coordinator/planning/city_model.hpp"

#include <vector>

namespace evbal {

/// Where the trips of these days go, by periods of two hours from the city's day start on. A period's counts of an
/// origin are shrunk towards those of the whole day as if these were 50 trips more; an origin without any keeps its
/// trips. Shares are whole thousandths that sum to one for each origin, rounded by largest remainders; pairs with none
/// are left out.
std::vector<TripPeriod> trip_shares(const City& city, const std::vector<DemandDay>& days);

/// The share of a region's trips that end in it, on average over this many regions.
double share_within(const TripPeriod& period, int regions);

}  // namespace evbal
