#include "faults/schedule/entry.hpp"

#include <algorithm>

namespace evbal {

std::string read_name(YamlMap& map) {
  const auto value = map.require("name");
  std::string name = value.text();
  const bool plain =
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.") == std::string::npos;
  if (name.empty() || !plain) {
    throw value.error("`" + name + "` is no name; use letters, digits, `-`, `_` and `.`");
  }
  return name;
}

std::vector<int> regions_with(const FaultContext& context, int min_points) {
  std::vector<int> regions;
  for (int region = 0; region < static_cast<int>(context.points_per_region.size()); ++region) {
    if (context.points_per_region[region] >= min_points) {
      regions.push_back(region);
    }
  }
  return regions;
}

std::vector<int> read_regions(const YamlValue& value, const FaultContext& context, bool with_points) {
  std::vector<int> regions;
  for (const auto& item : value.items()) {
    const int region = item.integer(0, static_cast<int>(context.points_per_region.size()) - 1);
    if (std::find(regions.begin(), regions.end(), region) != regions.end()) {
      throw item.error("region " + item.text() + " is given twice");
    }
    if (with_points && context.points_per_region[region] == 0) {
      std::string others;
      for (const int other : regions_with(context, 1)) {
        others += (others.empty() ? "" : ", ") + std::to_string(other);
      }
      throw item.error("region " + item.text() + " has no charging points; those with points are " + others);
    }
    regions.push_back(region);
  }
  if (regions.empty()) {
    throw value.error("names no region; give at least one");
  }
  std::sort(regions.begin(), regions.end());
  return regions;
}

}  // namespace evbal
