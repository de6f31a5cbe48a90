#pragma once

#include "agents/world/city.hpp"
#include "common/yaml.hpp"

namespace evbal {

/// The demand of `date`, one of the days of a city of factors. Equal packs give equal draws.
DemandDay drawn_day(const City& city, const std::string& date);

/// Sets km and minutes of every pair of a city of factors.
void set_travel(City& city);

/// Reads the factors of a pack: the map `factors` of its city.yaml and the tables beside it. Throws Error{bad_input}
/// with file and line.
CityFactors read_factors(const YamlValue& value, const City& city);

/// The map `factors` of a city.yaml, with its key; and the tables, written to the pack.
std::string factors_yaml(const CityFactors& factors);
void write_factor_tables(const City& city, const std::filesystem::path& folder);

}  // namespace evbal
