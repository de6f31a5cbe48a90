#pragma once

#include "agents/city/geometry.hpp"

#include <compare>
#include <filesystem>
#include <vector>

namespace evbal {

/// A corner of a zone in millionths of a degree (0.1 m): zones that touch share corners exactly.
struct Corner {
  int lat = 0;
  int lon = 0;
  auto operator<=>(const Corner&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm
};

LatLon point_of(Corner corner);

/// A polygon of the map that regions are merged from. Outer rings run counter-clockwise, holes clockwise; the first
/// corner is not repeated.
struct Zone {
  std::vector<std::vector<Corner>> rings;
  LatLon centre;         ///< of the area
  double area_m2 = 0.0;  ///< holes taken off
};

/// Twice the signed area, in square millionths of a degree; positive if counter-clockwise.
double signed_area(const std::vector<Corner>& ring);

/// Reads the polygons of a GeoJSON FeatureCollection, plain or compressed. Throws Error{bad_input} if it is none.
std::vector<Zone> read_zones(const std::filesystem::path& file);

/// The outer rings of zones, for looking up points.
std::vector<Outline> outlines_of(const std::vector<Zone>& zones);

/// For each zone the zones that share an edge with it, ascending.
std::vector<std::vector<int>> neighbours_of(const std::vector<Zone>& zones);

}  // namespace evbal
