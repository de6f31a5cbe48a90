#pragma once

#include "tools/ingest/zones.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string_view>

namespace evbal {

/// Places for what is known by zone only: spread evenly over the zone.
class ZonePlaces {
 public:
  /// Zones by name; they must outlive this. `decimal` is the point or comma with which whole numbers may be written.
  explicit ZonePlaces(const std::vector<Zone>& zones, char decimal = '.');

  /// A place in the zone of this name, the same for equal `draw`; nothing if there is no such zone. Without a zone of
  /// just this name it is the only one whose name is the same whole number: 132, 0132 or 132.0.
  std::optional<LatLon> place(std::string_view name, std::uint64_t draw) const;

 private:
  const Zone* zone_of(std::string_view name) const;

  std::map<std::string, const Zone*, std::less<>> zones_;
  std::map<std::string, const Zone*> numbers_;  ///< null: several zones have the number
  char decimal_;
};

}  // namespace evbal
