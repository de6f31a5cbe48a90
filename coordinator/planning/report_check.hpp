#pragma once

#include "agents/protocol/messages.hpp"
#include "common/clock.hpp"

#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// What bounds a report.
struct ReportBounds {
  int vehicles = 0;         ///< of the whole fleet
  std::vector<int> points;  ///< installed, by region
  DayClock clock;
};

/// What is wrong with a report at the tick of a plan, in a few words; empty if nothing is. `region` of the report
/// exists. What it counts may have been counted since `last`, the tick of the plan before (or 0).
std::string complaint(const Report& report, int tick, int last, const ReportBounds& bounds);

/// The reports of a tick that hold, by region, and why the others do not, by region: of another tick or of no region of
/// the city, given twice, missing, or with a complaint. Of two of a region the first holds.
struct CheckedReports {
  std::vector<std::optional<Report>> good;
  std::vector<Rejection> rejected;
};
CheckedReports check_reports(const std::vector<Report>& reports, int tick, int last, const ReportBounds& bounds);

}  // namespace evbal
