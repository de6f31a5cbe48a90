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

std::vector<double> TripEndSums::place(std::vector<Region>& regions, double cell_m) const {
  std::vector<double> spread;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const Sums& sums = sums_[r];
    double square = cell_m * cell_m / 6.0;
    if (sums.trips > 0.0) {
      const LocalPoint mean{sums.east / sums.trips, sums.north / sums.trips};
      const LatLon centroid = frame_.global(mean);
      regions[r].centroid = rounded(centroid);
      square += std::max(0.0, sums.square / sums.trips - mean.east * mean.east - mean.north * mean.north);
    }
    spread.push_back(rounded(std::sqrt(square) / 1000.0, 1e3));
  }
  return spread;
}

}  // namespace evbal
