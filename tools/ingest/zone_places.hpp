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
  /// Zones by name, of equal names the largest; they must outlive this.
  explicit ZonePlaces(const std::vector<Zone>& zones);

  /// A place in the zone of this name, the same for equal `draw`; nothing if there is no such zone.
  std::optional<LatLon> place(std::string_view name, std::uint64_t draw) const;

 private:
  std::map<std::string, const Zone*, std::less<>> zones_;
};

}  // namespace evbal
