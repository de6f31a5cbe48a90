#include "agents/world/geometry.hpp"

#include "common/contract.hpp"

#include <mrpt/math/TPolygon2D.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace evbal {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kAxis = 6378137.0;                                   // WGS84: semi-major axis, m
constexpr double kFlattening = 1.0 / 298.257223563;                   // WGS84
constexpr double kEccentricity2 = kFlattening * (2.0 - kFlattening);  // squared

Eigen::Matrix3d axes_at(LatLon at) {
  const double sin_lat = std::sin(at.lat * kDegree);
  const double cos_lat = std::cos(at.lat * kDegree);
  const double sin_lon = std::sin(at.lon * kDegree);
  const double cos_lon = std::cos(at.lon * kDegree);
  Eigen::Matrix3d axes;
  axes.col(0) << -sin_lon, cos_lon, 0.0;
  axes.col(1) << -sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat;
  axes.col(2) << cos_lat * cos_lon, cos_lat * sin_lon, sin_lat;
  return axes;
}

/// Earth-centred coordinates of a point on the ellipsoid.
Eigen::Vector3d earth_centred(LatLon at) {
  const Eigen::Vector3d up = axes_at(at).col(2);
  const double radius = kAxis / std::sqrt(1.0 - kEccentricity2 * up.z() * up.z());
  return {radius * up.x(), radius * up.y(), radius * (1.0 - kEccentricity2) * up.z()};
}

}  // namespace

double distance(LocalPoint a, LocalPoint b) {
  return std::hypot(a.east - b.east, a.north - b.north);
}

LocalFrame::LocalFrame(LatLon origin) : origin_(earth_centred(origin)), axes_(axes_at(origin)) {}

LocalPoint LocalFrame::local(LatLon point) const {
  const Eigen::Vector3d enu = axes_.transpose() * (earth_centred(point) - origin_);
  return {enu.x(), enu.y()};
}

LatLon LocalFrame::global(LocalPoint place) const {
  // Along the frame's up axis to the ellipsoid x^2/a^2 + y^2/a^2 + z^2/b^2 = 1, the crossing nearest to the origin.
  const Eigen::Vector3d scale(1.0 / kAxis, 1.0 / kAxis, 1.0 / (kAxis * (1.0 - kFlattening)));
  const Eigen::Vector3d start = scale.cwiseProduct(origin_ + axes_.col(0) * place.east + axes_.col(1) * place.north);
  const Eigen::Vector3d step = scale.cwiseProduct(axes_.col(2));
  const double b = start.dot(step) / step.squaredNorm();
  const double c = (start.squaredNorm() - 1.0) / step.squaredNorm();
  EVBAL_EXPECT(b * b > c, "a place within a few thousand km of the frame's origin");
  const double up = -b + std::sqrt(b * b - c);
  const Eigen::Vector3d point = (start + up * step).cwiseQuotient(scale);
  const double lat = std::atan2(point.z(), (1.0 - kEccentricity2) * std::hypot(point.x(), point.y()));
  return {lat / kDegree, std::atan2(point.y(), point.x()) / kDegree};
}

struct OutlineMap::Rings {
  struct Ring {
    int outline = 0;
    LocalPoint low;  // of the bounding box
    LocalPoint high;
    double area = 0.0;  ///< of the bounding box
    mrpt::math::TPolygon2D polygon;
  };
  LocalFrame frame;
  std::vector<Ring> rings;
};

OutlineMap::OutlineMap(std::span<const Outline> outlines) {
  EVBAL_EXPECT(!outlines.empty() && !outlines.front().empty() && !outlines.front().front().empty(),
               "at least one outline, whose first ring has points");
  auto rings = std::make_unique<Rings>(Rings{LocalFrame(outlines.front().front().front()), {}});
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (const auto& outline_ring : outlines[i]) {
      const LocalPoint first = rings->frame.local(outline_ring.front());
      Rings::Ring ring{static_cast<int>(i), first, first, 0.0, {}};
      for (const LatLon point : outline_ring) {
        const LocalPoint place = rings->frame.local(point);
        ring.low = {std::min(ring.low.east, place.east), std::min(ring.low.north, place.north)};
        ring.high = {std::max(ring.high.east, place.east), std::max(ring.high.north, place.north)};
        ring.polygon.emplace_back(place.east, place.north);
      }
      ring.area = (ring.high.east - ring.low.east) * (ring.high.north - ring.low.north);
      rings->rings.push_back(std::move(ring));
    }
  }
  std::stable_sort(rings->rings.begin(), rings->rings.end(),
                   [](const Rings::Ring& a, const Rings::Ring& b) { return a.area < b.area; });
  rings_ = std::move(rings);
}

OutlineMap::~OutlineMap() = default;
OutlineMap::OutlineMap(OutlineMap&&) noexcept = default;
OutlineMap& OutlineMap::operator=(OutlineMap&&) noexcept = default;

std::optional<int> OutlineMap::containing(LatLon point) const {
  const LocalPoint at = rings_->frame.local(point);
  for (const auto& ring : rings_->rings) {
    const bool in_box = at.east >= ring.low.east && at.east <= ring.high.east && at.north >= ring.low.north &&
                        at.north <= ring.high.north;
    if (in_box && ring.polygon.contains({at.east, at.north})) {
      return ring.outline;
    }
  }
  return std::nullopt;
}

OutlineMap::Nearest OutlineMap::nearest(LatLon point) const {
  if (const auto inside = containing(point)) {
    return {*inside, 0.0};
  }
  const LocalPoint at = rings_->frame.local(point);
  Nearest best{-1, std::numeric_limits<double>::infinity()};
  for (const auto& ring : rings_->rings) {
    const LocalPoint in_box{std::clamp(at.east, ring.low.east, ring.high.east),
                            std::clamp(at.north, ring.low.north, ring.high.north)};
    if (distance(at, in_box) < best.metres) {
      const double metres = ring.polygon.distance({at.east, at.north});
      if (metres < best.metres) {
        best = {ring.outline, metres};
      }
    }
  }
  return best;
}

std::vector<Outline> outlines_of(const std::vector<Region>& regions) {
  std::vector<Outline> outlines;
  outlines.reserve(regions.size());
  for (const auto& region : regions) {
    outlines.push_back(region.outline);
  }
  return outlines;
}

}  // namespace evbal
