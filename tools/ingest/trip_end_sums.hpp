#pragma once

#include "agents/world/geometry.hpp"

#include <vector>

namespace evbal {

/// Where the trip ends of each region lie.
class TripEndSums {
 public:
  /// At least one region.
  explicit TripEndSums(const std::vector<Region>& regions) : frame_(regions.front().centroid), sums_(regions.size()) {}

  /// `trips` of them, more than none, lie at `place`.
  void add(int region, LatLon place, double trips);

  /// Sets centroids to the mean trip end; regions without trips keep theirs. Returns the root mean square distance of
  /// trip ends from it, km, with that within a cell of `cell_m` metres.
  std::vector<double> place(std::vector<Region>& regions, double cell_m) const;

 private:
  struct Sums {
    double trips = 0.0;
    double east = 0.0;
    double north = 0.0;
    double square = 0.0;
  };
  LocalFrame frame_;
  std::vector<Sums> sums_;
};

}  // namespace evbal
