#pragma once

#include "experiments/study/design/page.hpp"
#include "experiments/study/statistics/primaries.hpp"

#include <string>
#include <vector>

namespace evbal {

/// The table of a comparison, and which aims it reaches: a row a variant, with `at` of its whole front, else of each
/// setting.
std::string compared(const CompareSection& section, const std::vector<FinishedDay>& days);

/// The primary endpoints, what they show by one rule for all, and what all other rows are.
std::string primaries(const std::vector<PrimaryAnswer>& answers);

}  // namespace evbal
