#pragma once

#include "agents/world/city.hpp"

#include <string>

namespace evbal {

/// A text as JSON and YAML both read it.
std::string quoted(const std::string& text);

/// GeoJSON's order: [longitude, latitude].
std::string position(LatLon point);

/// "[a, b, c]" of what `show` makes of each item.
template <class Items, class Show>
std::string list(const Items& items, Show show) {
  std::string out = "[";
  for (const auto& item : items) {
    out += (out.size() > 1 ? ", " : "") + show(item);
  }
  return out + "]";
}

/// The `stations` of a city.yaml, with their key.
std::string stations_yaml(const std::vector<Station>& stations, const std::vector<Region>& regions);

/// Writes a whole file. Throws Error{run_failed}.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace evbal
