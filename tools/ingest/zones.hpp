#pragma once

#include "agents/world/geometry.hpp"

#include <compare>
#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// A corner of a zone in millionths of a degree (0.1 m): zones that touch share corners exactly.
struct Corner {
  int lat = 0;  ///< millionths of a degree
  int lon = 0;  ///< millionths of a degree; beyond 180 degrees in a city across them
  /// By latitude, then longitude.
  auto operator<=>(const Corner&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm
};

/// The corner in degrees, longitude from -180 to 180.
LatLon point_of(Corner corner);

/// The corners of a ring in degrees; from 180 on as from -180 on if none lies west of that.
std::vector<LatLon> points_of(const std::vector<Corner>& ring);

/// A longitude as the same one within 180 degrees of `reference`.
double longitude_near(double lon, double reference);

/// A polygon of the map that regions are merged from, or several of one name. Outer rings run counter-clockwise, holes
/// clockwise; the first corner is not repeated.
struct Zone {
  std::vector<std::vector<Corner>> rings;  ///< outer rings and holes
  LatLon centre;                           ///< of the area
  double area_m2 = 0.0;                    ///< holes taken off
  std::string name;     ///< what ZoneFields::name says of it, without blanks around it; else its position in the
                        ///< file, from 0
  double weight = 0.0;  ///< what ZoneFields::weight says of it, else its area
};

/// Which fields of the file hold a zone's name and weight.
struct ZoneFields {
  std::string name;    ///< field, empty: none
  std::string weight;  ///< field, empty: none
};

/// Twice the signed area, in square millionths of a degree; positive if counter-clockwise.
double signed_area(const std::vector<Corner>& ring);

/// Adds a ring of a polygon, turned to its sense of rotation; leaves out one of less than three corners.
void add_ring(Zone& zone, const std::vector<LatLon>& ring, bool hole);

/// Sets centre and area from the rings, of which there must be one at least.
void measure(Zone& zone);

/// The zones of a file of polygons.
struct ZoneFile {
  std::vector<Zone> zones;  ///< in the order of the file
  std::string report;       ///< what was read, dropped and why; one item a line
};

/// Reads the polygons of a shapefile (.shp) or of a GeoJSON FeatureCollection, plain or compressed. Those of the same
/// name are one zone; it weighs the sum of theirs, or what each of them weighs if that is the same. What has no polygon
/// is left out and counted. Throws Error{bad_input} if it is no such file, has no polygon, or if one lacks a field
/// asked for.
ZoneFile read_zones(const std::filesystem::path& file, const ZoneFields& fields = {});

/// The outer rings of zones, for looking up points.
std::vector<Outline> outlines_of(const std::vector<Zone>& zones);

/// For each zone the zones that share an edge with it, ascending.
std::vector<std::vector<int>> neighbours_of(const std::vector<Zone>& zones);

}  // namespace evbal
