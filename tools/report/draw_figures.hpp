#pragma once

#include "experiments/study/statistics/study_figures.hpp"

#include <string>
#include <vector>

namespace evbal {

/// The figures as the texts of SVG files, in their order: drawn by the page's own scripts under Node.js with jsdom, the
/// packages `nodejs` and `node-jsdom`. Throws Error{run_failed} if these are missing, naming them.
std::vector<std::string> drawn_figures(const std::vector<StudyFigure>& figures);

}  // namespace evbal
