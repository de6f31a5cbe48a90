#pragma once

#include "experiments/study/statistics/front.hpp"
#include "experiments/study/store/sweep_origin.hpp"
#include "tools/report/sweep_summary.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
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

/// A sweep's part of a page.
struct SweepContent {
  std::string folder;                 ///< of the sweep
  SweepOrigin origin;                 ///< what it was made from
  std::string page;                   ///< page.md, empty if there is none
  int days = 0;                       ///< played, of all points
  std::vector<SweptPoint> points;     ///< in the order of the sweep
  std::vector<Answer> answers;        ///< what the variants came to against references
  std::optional<SweptBound> bound{};  ///< if it is known for all of its days
};

/// The sweep as the page reads it.
nlohmann::ordered_json sweep_json(const SweepContent& sweep);

}  // namespace evbal
