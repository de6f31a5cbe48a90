#pragma once

#include "experiments/study/statistics/primaries.hpp"

#include <string>
#include <vector>

namespace evbal {

/// What `evbal compare --csv` prints: a row a comparison, its numbers not rounded, cells empty where nothing is known.
/// `p_holm` is of the page's primary endpoints only.
std::string compared_csv(const std::vector<AnsweredQuestion>& answers, const std::vector<PrimaryAnswer>& primaries);

}  // namespace evbal
