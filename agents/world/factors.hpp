#pragma once

#include "agents/world/city.hpp"
#include "common/yaml.hpp"
#include "common/yaml_writer.hpp"

namespace evbal {

/// The demand of `date`, one of the days of a city of factors. Equal packs give equal draws.
DemandDay drawn_day(const City& city, const std::string& date);

/// Sets km and minutes of every pair of a city of factors.
void set_travel(City& city);

/// Reads the factors of a pack: the map `factors` of its city.yaml and the tables beside it. Throws Error{bad_input}
/// with file and line.
CityFactors read_factors(const YamlValue& value, const City& city);

/// Writes the key `factors` of a city.yaml.
void write_factors(YamlWriter& yaml, const CityFactors& factors);

/// Writes the tables of the factors into the pack in `folder`. Throws Error{run_failed}.
void write_factor_tables(const City& city, const std::filesystem::path& folder);

}  // namespace evbal
