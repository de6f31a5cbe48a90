#pragma once

#include "agents/world/city.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// Reads the regions.geojson of a pack (docs/city-packs.md). Throws Error{bad_input} with file and line.
std::vector<Region> read_regions(const std::filesystem::path& file);

/// The text of a regions.geojson that read_regions gives back, one region a line.
std::string regions_geojson(const std::vector<Region>& regions);

/// Reads the list `stations` of a YAML file that may hold more, such as a pack's city.yaml; their regions are named as
/// in `regions`. Throws Error{bad_input} with file and line.
std::vector<Station> read_stations(const std::filesystem::path& file, const std::vector<Region>& regions);

}  // namespace evbal
