#pragma once

#include "agents/world/geometry.hpp"

#include <optional>
#include <vector>

namespace evbal {

/// Where the trip ends of each region lie.
class TripEndSums {
 public:
  /// None yet. Places are measured in metres around `origin`.
  TripEndSums(int regions, LatLon origin) : frame_(origin), sums_(regions) {}

  /// `trips` of them, more than none, lie at `place`.
  void add(int region, LatLon place, double trips);

  /// The mean of a region's trip ends; nothing if it has none.
  std::optional<LatLon> mean(int region) const;

  /// The mean square distance of a region's trip ends from their mean, m2; 0 if it has none.
  double spread2(int region) const;

  /// Metres around the origin.
  const LocalFrame& frame() const { return frame_; }

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

/// Sets the regions' centroids to their mean trip ends; those without trips keep theirs. Returns the root mean square
/// distance of trip ends from it by region, km, with that within a cell of `cell_m` metres.
std::vector<double> place_regions(const TripEndSums& ends, double cell_m, std::vector<Region>& regions);

}  // namespace evbal
