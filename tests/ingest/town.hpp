#pragma once

#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// Sixteen zones of 0.02 x 0.015 degrees in four rows of four, as GeoJSON that a test may spoil.
namespace town {

/// A position as GeoJSON has it, of longitude and latitude.
using Position = std::function<std::string(double lon, double lat)>;

inline std::string in_degrees(double lon, double lat) {
  return "[" + std::to_string(lon) + "," + std::to_string(lat) + "]";
}

/// The coordinates of a Polygon: zone 0 to 15 from (9.70, 52.34) on, `gap` degrees apart.
inline std::string square(int zone, const Position& position = in_degrees, double gap = 0.0) {
  const double west = 9.70 + (0.02 + gap) * (zone % 4);
  const double south = 52.34 + (0.015 + gap) * static_cast<double>(zone / 4);
  return "[[" + position(west, south) + "," + position(west + 0.02, south) + "," +
         position(west + 0.02, south + 0.015) + "," + position(west, south + 0.015) + "," + position(west, south) +
         "]]";
}

inline std::string polygon(const std::string& coordinates) {
  return R"({"type": "Polygon", "coordinates": )" + coordinates + "}";
}

/// A Feature. `properties` and `geometry` are GeoJSON.
inline std::string feature(const std::string& properties, const std::string& geometry) {
  return R"({"type": "Feature", "properties": )" + properties + R"(, "geometry": )" + geometry + "}";
}

/// {"LocationID": ID}, where `id` is JSON.
inline std::string named(const std::string& id) {
  return R"({"LocationID": )" + id + "}";
}

/// The sixteen features, named 1 to 16 by numbers.
inline std::vector<std::string> features(const Position& position = in_degrees, double gap = 0.0) {
  std::vector<std::string> all;
  for (int zone = 0; zone < 16; ++zone) {
    all.push_back(feature(named(std::to_string(zone + 1)), polygon(square(zone, position, gap))));
  }
  return all;
}

/// A FeatureCollection; `members` stand before its features.
inline std::string collection(const std::vector<std::string>& features, const std::string& members = "") {
  std::string all = R"({"type": "FeatureCollection", )" + members + R"("features": [)";
  for (const auto& feature : features) {
    all += (&feature == &features.front() ? "\n" : ",\n") + feature;
  }
  return all + "]}";
}

/// The member `crs` of a FeatureCollection.
inline std::string crs(const std::string& name) {
  return R"("crs": {"type": "name", "properties": {"name": ")" + name + R"("}}, )";
}

}  // namespace town
}  // namespace evbal
