#pragma once

#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/design/page.hpp"

#include <string>
#include <vector>

namespace evbal {

/// The table of a comparison, what it shows by one rule for all, and which aims it reaches.
std::string compared(const CompareSection& section, const std::vector<FinishedDay>& days);

/// The table of a comparison of fronts.
std::string compared(const FrontsSection& section, const std::vector<FinishedDay>& days);

}  // namespace evbal
