#pragma once

#include "tools/fit/fit_city.hpp"

#include <filesystem>
#include <string>

namespace evbal {

/// What print_fit prints, as one JSON document with a line break at its end; shares in place of per cent, null where
/// there is nothing to tell. `model` is the file into which the model was written.
std::string fit_json(const City& city, const CityFit& fit, const std::filesystem::path& model);

}  // namespace evbal
