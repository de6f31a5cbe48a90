#pragma once

#include "experiments/study/design/page.hpp"
#include "experiments/study/statistics/page_days.hpp"
#include "experiments/study/statistics/primaries.hpp"
#include "experiments/study/statistics/study_figures.hpp"

#include <string>
#include <vector>

namespace evbal {

/// The texts of a page as Markdown; each is empty if the page has none, or ends with a line break.
struct PageText {
  std::string verdict{};        ///< what came of its questions
  std::string decided_after{};  ///< what was decided after some of the results were known
  std::string reading{};        ///< how to read it, and what it is made from
  std::string tables{};         ///< primary endpoints and sections
};

/// `answers` are its primary endpoints, `command` is what makes the page again.
PageText page_text(const Page& page, const PageDays& days, const std::vector<PrimaryAnswer>& answers,
                   const std::string& command);

/// The whole page as Markdown: title, verdict, figures (figures/NAME.svg), what was decided afterwards,
/// how to read it, and the tables.
std::string page_markdown(const std::string& title, const PageText& text, const std::vector<StudyFigure>& figures);

}  // namespace evbal
