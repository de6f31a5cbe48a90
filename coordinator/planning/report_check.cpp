#include "coordinator/planning/report_check.hpp"

#include "agents/protocol/measured.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace evbal {
namespace {

std::string validate_count(const std::string& what, std::int64_t is, const std::string& limit, std::int64_t at_most) {
  return is <= at_most ? "" : what + " " + std::to_string(is) + ", " + limit + " " + std::to_string(at_most);
}

std::int64_t vehicles_bound(const Report& report) {
  std::int64_t vehicles = 0;
  for (const UnderWay& cars : report.bound) {
    vehicles += cars.count;
  }
  return vehicles;
}

/// Counts against the lists beside them.
std::string validate_beside_lists(const Report& report) {
  if (std::ssize(report.plugged_since) != report.plugged) {
    return "plugged " + std::to_string(report.plugged) + ", plugged_since " +
           std::to_string(report.plugged_since.size());
  }
  if (std::ssize(report.reach_m) > report.low_battery) {
    return "low_battery " + std::to_string(report.low_battery) + ", reach_m " + std::to_string(report.reach_m.size());
  }
  return "";
}

/// Of what no sensor measures.
std::string validate_lists(const Report& report, int minute) {
  const auto& since = report.plugged_since;
  const bool in_order =
      std::ranges::is_sorted(since) && (since.empty() || (since.front() >= 0 && since.back() <= minute));
  if (!in_order) {
    return "plugged_since is not in order or not of the day";
  }
  const auto& reach = report.reach_m;
  if (!std::ranges::is_sorted(reach) || (!reach.empty() && reach.front() < 0)) {
    return "reach_m is not in order or below zero";
  }
  for (const UnderWay& cars : report.bound) {
    if (cars.region != report.region || cars.count < 1 || cars.minute < minute || cars.errand > Errand::charge) {
      return "bound has cars to elsewhere, none, or of the past";
    }
  }
  return "";
}

}  // namespace

std::string validate_unmeasured(const Report& report, int tick, const ReportBounds& bounds) {
  return report.tick == tick ? validate_lists(report, bounds.clock.minute_of(tick))
                             : "is of tick " + std::to_string(report.tick);
}

std::string validate(const Report& report, int tick, int last, const ReportBounds& bounds) {
  if (report.tick != tick) {
    return "is of tick " + std::to_string(report.tick);
  }
  for (const Measured& count : measured) {
    if (report.*count.member < 0) {
      return std::string(count.name) + " " + std::to_string(report.*count.member);
    }
  }
  const int minute = bounds.clock.minute_of(tick);
  const std::int64_t minutes = minute - bounds.clock.minute_of(last);
  const std::int64_t installed = bounds.points[static_cast<std::size_t>(report.region)];
  const std::int64_t here = std::int64_t{report.vacant} + report.low_battery + report.plugged;
  const std::int64_t demand = std::int64_t{report.demand} + report.waiting;
  for (std::string found : {validate_count("points", report.points, "installed", installed),
                            validate_count("plugged", report.plugged, "points", report.points),
                            validate_count("chargeable", report.chargeable, "vacant", report.vacant),
                            validate_count("completions", report.completions, "possible", installed * minutes),
                            validate_count("demand and waiting", demand, "possible",
                                           std::int64_t{most_passengers_a_minute} * bounds.clock.minutes()),
                            validate_beside_lists(report), validate_lists(report, minute),
                            validate_count("vehicles", here + vehicles_bound(report), "fleet", bounds.vehicles)}) {
    if (!found.empty()) {
      return found;
    }
  }
  return "";
}

CheckedReports check_reports(const std::vector<Report>& reports, int tick, int last, const ReportBounds& bounds) {
  const auto regions = static_cast<int>(bounds.points.size());
  CheckedReports checked;
  checked.good.resize(bounds.points.size());
  checked.readable.resize(bounds.points.size());
  std::vector<bool> heard(bounds.points.size());
  const auto reject = [&](int region, std::string reason) { checked.rejected.push_back({region, std::move(reason)}); };
  for (const Report& report : reports) {
    if (report.region < 0 || report.region >= regions) {
      reject(report.region, "is no region of this city");
      continue;
    }
    const auto region = static_cast<std::size_t>(report.region);
    std::string why_not = checked.good[region] ? "came twice" : validate(report, tick, last, bounds);
    if (!checked.readable[region] && validate_unmeasured(report, tick, bounds).empty()) {
      checked.readable[region] = report;
    }
    if (why_not.empty()) {
      checked.good[region] = report;
    } else {
      reject(report.region, std::move(why_not));
    }
    heard[region] = true;
  }
  for (int region = 0; region < regions; ++region) {
    if (!heard[static_cast<std::size_t>(region)]) {
      reject(region, "is missing");
    }
  }
  std::ranges::stable_sort(checked.rejected, {}, &Rejection::region);
  return checked;
}

}  // namespace evbal
