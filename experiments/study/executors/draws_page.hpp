#pragma once

#include "experiments/study/executors/monte_carlo.hpp"

#include <string>

namespace evbal {

/// draws.md: how metrics are spread over the draws, which draws were worst, and which fault did it, a section a
/// controller.
std::string draws_markdown(const DrawsResult& result);

/// influence.csv: a row a controller and drawn quantity, the strongest first.
std::string influence_csv(const DrawsResult& result);

}  // namespace evbal
