#pragma once

#include "experiments/study/design/finished_day.hpp"

#include <string>
#include <vector>

namespace evbal {

/// Throws Error{bad_input}, with the name that may be meant, unless the days, of which there is one at least, have such
/// a metric.
void expect_metric(const std::string& name, const std::vector<FinishedDay>& days);

/// Throws Error{bad_input}, with the name that may be meant, unless one of the days is of such a variant.
void expect_variant(const std::string& name, const std::vector<FinishedDay>& days);

}  // namespace evbal
