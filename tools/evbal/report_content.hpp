#pragma once

#include "experiments/record/recorded_run.hpp"
#include "experiments/study/design/day_filter.hpp"
#include "tools/report/report.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// The page on these runs (at least one). Map, forecasts and thresholds come from the city's pack and model where the
/// runs found them; what cannot be read there is left out, and the page says so.
PageContent content_on(const std::vector<RecordedRun>& runs);

/// The page on the finished sweep in `folder`, whose variants are compared with those named by `against` (none: the
/// sweep's first, unless it has its own page of answers), and on `runs`. If `filter` asks for some of the days, they
/// and those of `against` alone are shown, without the answers, which are of all days. Throws Error{bad_input} if the
/// sweep is not finished or a name is unknown.
PageContent content_on(const std::filesystem::path& folder, const std::vector<std::string>& against,
                       const DayFilter& filter, const std::vector<RecordedRun>& runs);

}  // namespace evbal
