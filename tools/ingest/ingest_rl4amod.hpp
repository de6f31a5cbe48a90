#pragma once

#include "tools/ingest/ingest_trips.hpp"

#include <filesystem>
#include <string>

namespace evbal {

/// A city of a scenario of RL4AMOD.
struct Rl4amodCity {
  IngestedCity made;   ///< the city, its days, and what was read
  std::string prices;  ///< prices.csv: `step,origin,destination,price,minutes`, means over the trips of each step
};

/// Makes a city of a scenario file of RL4AMOD (read_rl4amod) and notes (read_rl4amod_notes): its first hour begins the
/// day; the trips of each step and pair are drawn for every day from a Poisson law around the file's. Regions stand
/// where their travel times put them, which is nowhere on earth. Throws Error{bad_input}.
Rl4amodCity ingest_rl4amod(const std::filesystem::path& scenario, const std::filesystem::path& notes);

}  // namespace evbal
