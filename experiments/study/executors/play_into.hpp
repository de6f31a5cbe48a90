#pragma once

#include "experiments/scenario/scenario.hpp"

#include <filesystem>
#include <string>

namespace evbal {

/// Plays a day in this process and adds its result, with the time that it took, to the database (sweep_file.hpp).
void play_into(const std::filesystem::path& file, const std::string& key, const Scenario& scenario);

}  // namespace evbal
