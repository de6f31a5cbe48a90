#include "tools/ingest/trip_end_sums.hpp"

#include "tools/ingest/rounding.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {

void TripEndSums::add(int region, LatLon place, double trips) {
  const LocalPoint at = frame_.local(place);
  Sums& sums = sums_[region];
  sums.trips += trips;
  sums.east += trips * at.east;
  sums.north += trips * at.north;
  sums.square += trips * (at.east * at.east + at.north * at.north);
}

std::optional<LatLon> TripEndSums::mean(int region) const {
  const Sums& sums = sums_[region];
  return sums.trips > 0.0 ? std::optional(frame_.global({sums.east / sums.trips, sums.north / sums.trips}))
                          : std::nullopt;
}

double TripEndSums::spread2(int region) const {
  const Sums& sums = sums_[region];
  if (sums.trips == 0.0) {
    return 0.0;
  }
  const double east = sums.east / sums.trips;
  const double north = sums.north / sums.trips;
  return std::max(0.0, sums.square / sums.trips - east * east - north * north);
}

std::vector<double> place_regions(const TripEndSums& ends, double cell_m, std::vector<Region>& regions) {
  std::vector<double> spread;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const auto region = static_cast<int>(r);
    const auto mean = ends.mean(region);
    regions[r].centroid = mean ? rounded(*mean) : regions[r].centroid;
    spread.push_back(rounded(std::sqrt(cell_m * cell_m / 6.0 + ends.spread2(region)) / 1000.0, 1e3));
  }
  return spread;
}

}  // namespace evbal
