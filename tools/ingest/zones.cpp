#include "tools/ingest/zones.hpp"

#include "common/error.hpp"
#include "tools/ingest/read_zones.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace evbal {
namespace {

constexpr double kPerDegree = 1e6;
constexpr double kMetresPerDegree = 111'195.0;  // of latitude, mean earth

}  // namespace

LatLon point_of(Corner corner) {
  return {corner.lat / kPerDegree, longitude_near(corner.lon / kPerDegree, 0.0)};
}

std::vector<LatLon> points_of(const std::vector<Corner>& ring) {
  constexpr int kHalfTurn = 180'000'000;
  const bool beyond = std::all_of(ring.begin(), ring.end(), [](Corner corner) { return corner.lon >= kHalfTurn; });
  std::vector<LatLon> points;
  points.reserve(ring.size());
  for (const Corner corner : ring) {
    points.push_back(point_of({corner.lat, beyond ? corner.lon - 2 * kHalfTurn : corner.lon}));
  }
  return points;
}

double longitude_near(double lon, double reference) {
  return lon - reference > 180.0 ? lon - 360.0 : lon - reference < -180.0 ? lon + 360.0 : lon;
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

void add_ring(Zone& zone, const std::vector<LatLon>& ring, bool hole) {
  std::vector<Corner> corners;
  for (const LatLon point : ring) {
    const double lon = longitude_near(point.lon, ring.front().lon);
    const Corner corner{static_cast<int>(std::lround(point.lat * kPerDegree)),
                        static_cast<int>(std::lround(lon * kPerDegree))};
    if (corners.empty() || corner != corners.back()) {
      corners.push_back(corner);
    }
  }
  while (corners.size() > 1 && corners.front() == corners.back()) {
    corners.pop_back();
  }
  if (corners.size() < 3) {
    return;
  }
  if ((signed_area(corners) > 0.0) == hole) {
    std::reverse(corners.begin(), corners.end());
  }
  zone.rings.push_back(std::move(corners));
}

void measure(Zone& zone) {
  // The shoelace formula, in degrees: zones are small.
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
  zone.centre = area > 0.0 ? LatLon{start.lat + lat / area, longitude_near(start.lon + lon / area, 0.0)} : start;
  zone.area_m2 = area * kMetresPerDegree * kMetresPerDegree * std::cos(start.lat * std::acos(-1.0) / 180.0);
}

ZoneFile read_zones(const std::filesystem::path& file, const ZoneFields& fields) {
  return is_shapefile(file) ? read_shapefile_zones(file, fields) : read_geojson_zones(file, fields);
}

std::vector<Outline> outlines_of(const std::vector<Zone>& zones) {
  std::vector<Outline> outlines;
  for (const auto& zone : zones) {
    Outline& outline = outlines.emplace_back();
    for (const auto& ring : zone.rings) {
      if (signed_area(ring) > 0.0) {
        outline.push_back(points_of(ring));
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
