#pragma once

#include "experiments/study/design/page.hpp"
#include "experiments/study/statistics/page_days.hpp"
#include "experiments/study/statistics/page_markdown.hpp"
#include "experiments/study/statistics/primaries.hpp"
#include "experiments/study/statistics/study_figures.hpp"
#include "experiments/study/store/sweep_origin.hpp"

#include <filesystem>
#include <vector>

/// The page of a finished sweep, made from what is stored of it.
namespace evbal {

/// What a sweep is asked, and the days that answer.
struct StudyPage {
  Page page;                             ///< without a title if it asks nothing
  SweepOrigin origin;                    ///< of the sweep
  PageDays days;                         ///< with the bounds that are kept
  std::vector<PrimaryAnswer> primaries;  ///< of the page
  std::vector<StudyFigure> figures;      ///< of the page
};

/// Reads the sweep in `folder`. Throws Error{bad_input} if there is none, or if it is not finished.
StudyPage read_study_page(const std::filesystem::path& folder);

/// The texts of the page.
PageText study_text(const StudyPage& study);

/// Writes page.md and its figures, figures/NAME.svg, into the sweep's folder, in place of those that were there. If the
/// figures cannot be drawn they are left out, and a line on stderr says so.
void write_study_page(const std::filesystem::path& folder, const StudyPage& study);

/// Writes the figures alone, and gives their folder. Throws Error{bad_input} if the page has none, Error{run_failed} if
/// they cannot be drawn.
std::filesystem::path write_study_figures(const std::filesystem::path& folder, const StudyPage& study);

}  // namespace evbal
