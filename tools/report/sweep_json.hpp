#pragma once

#include "experiments/study/statistics/front.hpp"
#include "experiments/study/statistics/page_markdown.hpp"
#include "experiments/study/statistics/study_figures.hpp"
#include "experiments/study/store/sweep_origin.hpp"
#include "tools/report/sweep_summary.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace evbal {

/// The fewest passengers that the days of one scenario and schedule of faults must lose, in the mean over days and
/// seeds.
struct SweptBound {
  std::string scenario{};             ///< its name
  std::string faults{};               ///< name of the schedule
  std::vector<FrontPoint> corners{};  ///< lost passengers by idle km
};

/// What a sweep was asked, answered.
struct SweptAnswers {
  PageText text;                       ///< in its parts
  std::vector<StudyFigure> figures{};  ///< in their order
};

/// A sweep's part of a page.
struct SweepContent {
  std::string folder;                ///< of the sweep
  SweepOrigin origin;                ///< what it was made from
  SweptAnswers page{};               ///< empty if the sweep asks nothing
  int days = 0;                      ///< played, of all points
  std::vector<SweptPoint> points;    ///< in the order of the sweep
  std::vector<Answer> answers;       ///< what the variants came to against references
  std::vector<SweptBound> bounds{};  ///< of those scenarios and schedules for each of whose days it is known
};

/// The sweep as the page reads it.
nlohmann::ordered_json sweep_json(const SweepContent& sweep);

}  // namespace evbal
