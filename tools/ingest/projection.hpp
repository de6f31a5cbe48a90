#pragma once

#include "agents/world/city.hpp"

#include <memory>
#include <optional>
#include <string>

namespace evbal {

/// A coordinate reference system, of which positions are turned into WGS84 degrees by PROJ.
class Projection {
 public:
  /// `definition` is WKT, as in a .prj file, or a code such as EPSG:2263 or urn:ogc:def:crs:EPSG::2263. Throws
  /// Error{bad_input} without a file's name if PROJ does not know it, or cannot turn it into WGS84.
  explicit Projection(const std::string& definition);
  ~Projection();
  /// Takes over the other's system.
  Projection(Projection&&) noexcept;
  /// Takes over the other's system.
  Projection& operator=(Projection&&) noexcept;

  /// The place of a position, x to the east and y to the north; nothing if it lies where the system is not used.
  std::optional<LatLon> place(double x, double y) const;

  /// The system's name.
  const std::string& name() const;

 private:
  struct System;
  std::unique_ptr<const System> system_;
};

}  // namespace evbal
