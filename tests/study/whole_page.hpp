#pragma once

#include "experiments/study/statistics/page_markdown.hpp"

#include <string>

namespace evbal {

/// A page as it is written for these days.
inline std::string whole_page(const Page& page, const PageDays& days, const std::string& command) {
  const auto answers = primary_answers(page, days.days);
  return page_markdown(page.title, page_text(page, days, answers, command), study_figures(page, days, answers));
}

}  // namespace evbal
