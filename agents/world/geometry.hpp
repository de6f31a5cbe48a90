#pragma once

#include "agents/world/city.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace evbal {

/// Metres east and north of a LocalFrame's origin.
struct LocalPoint {
  double east = 0.0;   ///< metres
  double north = 0.0;  ///< metres
};

/// Metres between two places.
double distance(LocalPoint a, LocalPoint b);

/// The plane that touches the WGS84 ellipsoid at `origin` (its east-north-up frame without the up): true to 1e-4 within
/// 60 km.
class LocalFrame {
 public:
  /// Its centre is `origin`.
  explicit LocalFrame(LatLon origin);

  /// A place in metres from the centre.
  LocalPoint local(LatLon point) const;

  /// The point on the ellipsoid that local() takes to `place`.
  LatLon global(LocalPoint place) const;

 private:
  Eigen::Vector3d origin_;  ///< earth-centred
  Eigen::Matrix3d axes_;    ///< columns east, north, up
};

using Outline = std::vector<std::vector<LatLon>>;  ///< rings, as in Region

/// Finds the outline that a point lies in.
class OutlineMap {
 public:
  /// At least one outline; they need not outlive this.
  explicit OutlineMap(std::span<const Outline> outlines);
  ~OutlineMap();
  /// Takes over the other's outlines.
  OutlineMap(OutlineMap&&) noexcept;
  /// Takes over the other's outlines.
  OutlineMap& operator=(OutlineMap&&) noexcept;

  /// The outline that contains the point, if any does; the smallest of several (one may lie in a hole of another).
  std::optional<int> containing(LatLon point) const;

  /// The outline that contains the point, else the one with the nearest edge; and how many metres away it is.
  struct Nearest {
    int outline = 0;      ///< position in the list
    double metres = 0.0;  ///< to it; 0 inside
  };
  /// The outline that a place lies in, else the nearest.
  Nearest nearest(LatLon point) const;

 private:
  struct Rings;
  std::unique_ptr<const Rings> rings_;
};

/// Outlines by region.
std::vector<Outline> outlines_of(const std::vector<Region>& regions);

}  // namespace evbal
