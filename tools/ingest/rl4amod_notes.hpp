#pragma once

#include "agents/world/city.hpp"

#include <cstdint>
#include <filesystem>

namespace evbal {

/// What a scenario of RL4AMOD does not say: read from a small YAML file such as tools/ingest/brooklyn.yaml.
struct Rl4amodNotes {
  City city;                  ///< name, source, days, step, fleet, passengers and chargers but for their places
  double demand_ratio = 1.0;  ///< trips asked for a trip of the file
  std::uint64_t seed = 1;     ///< of the days that are drawn
  double kmh = 20.0;          ///< speed: the file has minutes only
  int stations = 0;           ///< to place
  int points = 0;             ///< of all stations, >= stations
};

/// Reads such a file. Throws Error{bad_input} with file and line.
Rl4amodNotes read_rl4amod_notes(const std::filesystem::path& file);

}  // namespace evbal
