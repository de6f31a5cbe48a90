#pragma once

#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/design/page.hpp"

#include <string>
#include <vector>

namespace evbal {

/// The page as Markdown. `command` is what makes it again.
std::string page_markdown(const Page& page, std::vector<FinishedDay> days, const std::string& command);

}  // namespace evbal
