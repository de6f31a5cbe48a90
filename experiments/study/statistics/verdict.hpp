#pragma once

#include "experiments/study/design/page.hpp"
#include "experiments/study/statistics/page_days.hpp"
#include "experiments/study/statistics/primaries.hpp"

#include <string>
#include <vector>

namespace evbal {

/// What came of the page's questions, as Markdown: its introduction, a paragraph each, how far the best of their
/// variants is from what could be, and what the words mean. Empty if the page has no verdict. `answers` are the page's
/// primary endpoints.
std::string verdict_text(const Page& page, const PageDays& days, const std::vector<PrimaryAnswer>& answers);

/// A share as per cent with its sign, such as "−14.5 %".
std::string signed_per_cent(double share);

/// The ends of an interval of shares, as per cent, or that it is not known.
std::string interval_words(const Interval& interval);

}  // namespace evbal
