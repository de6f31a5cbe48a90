#pragma once

#include "experiments/study/statistics/study_figures.hpp"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace evbal {

/// A study's figures as the scripts that draw them read them.
nlohmann::ordered_json figures_json(const std::vector<StudyFigure>& figures);

}  // namespace evbal
