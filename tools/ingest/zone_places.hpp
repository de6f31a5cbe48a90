#pragma once

#include "tools/ingest/zones.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// Places for what is known by zone only: spread evenly over the zone.
class ZonePlaces {
 public:
  /// Zones by name; they must outlive this. `decimal` is the point or comma with which whole numbers may be written.
  explicit ZonePlaces(const std::vector<Zone>& zones, char decimal = '.');

  /// A place in the zone of this name, the same for equal `draw`; nothing if there is no such zone. Without a zone of
  /// just this name it is the only one whose name is the same whole number: 132, 0132 or 132.0.
  std::optional<LatLon> place(std::string_view name, std::uint64_t draw) const;

  /// The reason under which rows are counted whose zone is none of these, with the name of one.
  std::string no_zone() const;

  /// The zone that place() draws in, null if there is none.
  const Zone* zone_of(std::string_view name) const;

 private:
  /// An outer ring of a zone.
  struct Part {
    const std::vector<Corner>* ring;
    Corner low;          ///< of its box
    Corner high;         ///< of its box
    double areas = 0.0;  ///< of the zone's parts up to this one
  };
  struct Shape {
    const Zone* zone;
    std::vector<Part> parts;
  };

  static Shape shape_of(const Zone& zone);
  const Shape* shape_named(std::string_view name) const;

  std::vector<Shape> shapes_;
  std::map<std::string, const Shape*, std::less<>> names_;
  std::map<std::string, const Shape*> numbers_;  ///< null: several zones have the number
  char decimal_;
};

}  // namespace evbal
