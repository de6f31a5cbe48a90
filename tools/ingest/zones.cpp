#include "tools/ingest/zones.hpp"

#include "common/error.hpp"
#include "tools/ingest/lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace evbal {
namespace {

using nlohmann::json;

constexpr double kPerDegree = 1e6;
constexpr double kMetresPerDegree = 111'195.0;  // of latitude, mean earth

std::vector<Corner> read_ring(const json& positions) {
  std::vector<Corner> ring;
  for (const auto& position : positions) {
    const auto lon = position.at(0).get<double>();
    const auto lat = position.at(1).get<double>();
    if (std::abs(lat) > 90.0 || std::abs(lon) > 180.0) {
      throw bad_input("a position is not in degrees (WGS84)");
    }
    const Corner corner{static_cast<int>(std::lround(lat * kPerDegree)),
                        static_cast<int>(std::lround(lon * kPerDegree))};
    if (ring.empty() || corner != ring.back()) {
      ring.push_back(corner);
    }
  }
  while (ring.size() > 1 && ring.front() == ring.back()) {
    ring.pop_back();
  }
  return ring;
}

/// Adds a polygon's rings, turned to their sense of rotation.
void add_polygon(const json& rings, Zone& zone) {
  for (std::size_t r = 0; r < rings.size(); ++r) {
    auto ring = read_ring(rings[r]);
    if (ring.size() < 3) {
      continue;
    }
    if ((signed_area(ring) > 0.0) != (r == 0)) {
      std::reverse(ring.begin(), ring.end());
    }
    zone.rings.push_back(std::move(ring));
  }
}

/// Area and its centre by the shoelace formula, in degrees: zones are small.
void measure(Zone& zone) {
  const Corner origin = zone.rings.front().front();
  double area = 0.0;
  double lat = 0.0;
  double lon = 0.0;
  for (const auto& ring : zone.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Corner& next = ring[(i + 1) % ring.size()];
      const double ax = (ring[i].lon - origin.lon) / kPerDegree;
      const double ay = (ring[i].lat - origin.lat) / kPerDegree;
      const double bx = (next.lon - origin.lon) / kPerDegree;
      const double by = (next.lat - origin.lat) / kPerDegree;
      const double cross = ax * by - bx * ay;
      area += cross / 2.0;
      lon += (ax + bx) * cross / 6.0;
      lat += (ay + by) * cross / 6.0;
    }
  }
  const LatLon start = point_of(origin);
  zone.centre = area > 0.0 ? LatLon{start.lat + lat / area, start.lon + lon / area} : start;
  zone.area_m2 = area * kMetresPerDegree * kMetresPerDegree * std::cos(start.lat * std::acos(-1.0) / 180.0);
}

Zone read_zone(const json& feature) {
  const json& geometry = feature.at("geometry");
  const auto& type = geometry.at("type").get_ref<const std::string&>();
  Zone zone;
  if (type == "Polygon") {
    add_polygon(geometry.at("coordinates"), zone);
  } else if (type == "MultiPolygon") {
    for (const auto& polygon : geometry.at("coordinates")) {
      add_polygon(polygon, zone);
    }
  } else {
    throw bad_input("geometry `" + type + "` is neither Polygon nor MultiPolygon");
  }
  return zone;
}

}  // namespace

LatLon point_of(Corner corner) {
  return {corner.lat / kPerDegree, corner.lon / kPerDegree};
}

double signed_area(const std::vector<Corner>& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Corner& a = ring[i];
    const Corner& b = ring[(i + 1) % ring.size()];
    twice += static_cast<double>(static_cast<long long>(a.lon) * b.lat - static_cast<long long>(b.lon) * a.lat);
  }
  return twice;
}

std::vector<Zone> read_zones(const std::filesystem::path& file) {
  std::vector<Zone> zones;
  try {
    const json collection = json::parse(unpacked_text(file));
    for (const auto& feature : collection.at("features")) {
      Zone zone = read_zone(feature);
      if (!zone.rings.empty()) {
        measure(zone);
        zones.push_back(std::move(zone));
      }
    }
  } catch (const json::exception& error) {
    throw bad_input(file.string(), 0, std::string("is no GeoJSON FeatureCollection of polygons: ") + error.what());
  }
  if (zones.empty()) {
    throw bad_input(file.string(), 0, "has no polygon");
  }
  return zones;
}

std::vector<Outline> outlines_of(const std::vector<Zone>& zones) {
  std::vector<Outline> outlines;
  for (const auto& zone : zones) {
    Outline& outline = outlines.emplace_back();
    for (const auto& ring : zone.rings) {
      if (signed_area(ring) > 0.0) {
        auto& points = outline.emplace_back();
        std::transform(ring.begin(), ring.end(), std::back_inserter(points), point_of);
      }
    }
  }
  return outlines;
}

std::vector<std::vector<int>> neighbours_of(const std::vector<Zone>& zones) {
  std::map<std::pair<Corner, Corner>, int> owner;
  const auto for_each_edge = [&](auto use) {
    for (std::size_t z = 0; z < zones.size(); ++z) {
      for (const auto& ring : zones[z].rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          use(static_cast<int>(z), ring[i], ring[(i + 1) % ring.size()]);
        }
      }
    }
  };
  for_each_edge([&](int zone, Corner a, Corner b) { owner.emplace(std::pair(a, b), zone); });
  std::vector<std::set<int>> found(zones.size());
  for_each_edge([&](int zone, Corner a, Corner b) {
    const auto other = owner.find({b, a});
    if (other != owner.end() && other->second != zone) {
      found[zone].insert(other->second);
      found[other->second].insert(zone);
    }
  });
  std::vector<std::vector<int>> neighbours;
  neighbours.reserve(found.size());
  for (const auto& set : found) {
    neighbours.emplace_back(set.begin(), set.end());
  }
  return neighbours;
}

}  // namespace evbal
