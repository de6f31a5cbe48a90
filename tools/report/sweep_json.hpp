#pragma once

#include "experiments/study/store/sweep_origin.hpp"
#include "tools/report/sweep_summary.hpp"

#include <nlohmann/json_fwd.hpp>

namespace evbal {

/// A sweep's part of a page.
struct SweepContent {
  std::string folder;              ///< of the sweep
  SweepOrigin origin;              ///< what it was made from
  std::string page;                ///< page.md, empty if there is none
  int days = 0;                    ///< played, of all points
  std::vector<SweptPoint> points;  ///< in the order of the sweep
  std::vector<Answer> answers;     ///< what the variants came to against references
};

/// The sweep as the page reads it.
nlohmann::ordered_json sweep_json(const SweepContent& sweep);

}  // namespace evbal
