#pragma once

#include "experiments/search/worst_search.hpp"

#include <string>
#include <vector>

namespace evbal {

/// path.csv: a row a trial, with its harm, the most harm so far, and its faults in words.
std::string path_csv(const std::vector<Trial>& trials, const Ingredients& ingredients);

}  // namespace evbal
