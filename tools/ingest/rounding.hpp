#pragma once

#include "agents/world/geometry.hpp"

#include <cmath>

namespace evbal {

/// `value` to the nearest 1 / `parts`, so that it is short in a file.
inline double rounded(double value, double parts) {
  return std::round(value * parts) / parts;
}

/// A place to about a metre.
inline LatLon rounded(LatLon place) {
  constexpr double parts = 1e5;
  return {rounded(place.lat, parts), rounded(place.lon, parts)};
}

}  // namespace evbal
