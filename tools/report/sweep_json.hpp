#pragma once

#include "experiments/study/store/sweep_origin.hpp"
#include "tools/report/sweep_summary.hpp"

#include <nlohmann/json_fwd.hpp>

namespace evbal {

/// A sweep's part of a page.
struct SweepContent {
  std::string folder;
  SweepOrigin origin;
  std::string page;  ///< page.md, empty if there is none
  int days = 0;      ///< played, of all points
  std::vector<SweptPoint> points;
  std::vector<Answer> answers;
};

/// The sweep as the page reads it.
nlohmann::ordered_json sweep_json(const SweepContent& sweep);

}  // namespace evbal
