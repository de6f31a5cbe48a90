#pragma once

#include "agents/protocol/messages.hpp"
#include "common/clock.hpp"

#include <optional>
#include <string>
#include <vector>

/// Decides which reports are garbage. One that cannot be true is rejected and an estimate stands in for it
/// (FleetEstimate): sensors may lie, and the day goes on. What no sensor measures is checked in all messages by
/// agents/protocol/message_check.hpp, and there garbage ends the run.
namespace evbal {

/// Passengers who appear in one region in a minute, at most; no city comes near.
inline constexpr int most_passengers_a_minute = 1000;

/// What bounds a report.
struct ReportBounds {
  int vehicles = 0;         ///< of the whole fleet
  std::vector<int> points;  ///< installed, by region
  DayClock clock;           ///< of the run
};

/// What is wrong with a report at the tick of a plan, in a few words; empty if nothing is. `region` of the report
/// exists. What it counts may have been counted since `last`, the tick of the plan before (or 0).
std::string validate(const Report& report, int tick, int last, const ReportBounds& bounds);

/// Likewise of what no sensor measures: its tick, and its lists by themselves. If nothing is wrong there, a number may
/// lie, but the rest can be used.
std::string validate_unmeasured(const Report& report, int tick, const ReportBounds& bounds);

/// The reports of a tick that are believed, by region, and why the others are rejected, by region: they are missing, of
/// no region of the city, the second of their region, or not valid.
struct CheckedReports {
  std::vector<std::optional<Report>> good;      ///< by region
  std::vector<std::optional<Report>> readable;  ///< by region: these, and others whose unmeasured part can be true
  std::vector<Rejection> rejected;              ///< by region
};
/// Checks the reports of a tick one by one.
CheckedReports check_reports(const std::vector<Report>& reports, int tick, int last, const ReportBounds& bounds);

}  // namespace evbal
