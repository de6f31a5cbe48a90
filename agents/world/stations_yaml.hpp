#pragma once

#include "agents/world/city.hpp"
#include "common/yaml_writer.hpp"

#include <string>

namespace evbal {

/// Writes the key `stations` of a city.yaml.
void write_stations(YamlWriter& yaml, const std::vector<Station>& stations, const std::vector<Region>& regions);

/// A YAML file with that key alone.
std::string stations_yaml(const std::vector<Station>& stations, const std::vector<Region>& regions);

}  // namespace evbal
