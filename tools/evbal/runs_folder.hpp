#pragma once

#include "experiments/scenario/scenario.hpp"

#include <filesystem>

/// The folder runs/ of the current directory, in which runs lie that were given no other place.
namespace evbal {

/// Makes a directory of its own there for the runs of a scenario, at once, so that two never take the same.
std::filesystem::path claim_folder(const Scenario& scenario);

/// The folder in it in which bounds of days are kept (experiments/bound/bound_file.hpp).
std::filesystem::path bounds_folder();

/// Lets the link `latest` there lead to this directory, which lies beside it. Something else of that name is left
/// alone.
void name_latest(const std::filesystem::path& folder);

}  // namespace evbal
