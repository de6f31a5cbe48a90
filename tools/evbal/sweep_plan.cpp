#include "tools/evbal/sweep_plan.hpp"

#include "common/decimal.hpp"
#include "experiments/progress/live_view.hpp"
#include "tools/evbal/console_table.hpp"

#include <cstddef>
#include <utility>

namespace evbal {
namespace {

/// Days of one variant in one scenario.
struct PlannedDays {
  std::string scenario;
  std::string variant;
  int days = 0;
  int played = 0;
  int failed = 0;        ///< of those that are left
  int timed = 0;         ///< of these
  double seconds = 0.0;  ///< that they took

  int left() const { return days - played; }
  /// That what is left will take, so many days at a time; nothing if there is no saying.
  std::optional<double> to_come(int jobs) const {
    return left() == 0 ? std::optional(0.0) : timed > 0 ? std::optional(left() * seconds / timed / jobs) : std::nullopt;
  }
};

std::vector<PlannedDays> planned(const Sweep& sweep, const std::vector<std::string>& keys,
                                 const std::map<std::string, std::optional<double>>& played,
                                 const std::map<std::string, std::string>& failed) {
  std::vector<PlannedDays> rows;
  std::map<std::pair<std::string, std::string>, std::size_t> positions;
  for (std::size_t i = 0; i < sweep.days.size(); ++i) {
    const SweptDay& day = sweep.days[i];
    const auto [at, is_new] = positions.emplace(std::pair(day.scenario, day.variant), rows.size());
    if (is_new) {
      rows.push_back({.scenario = day.scenario, .variant = day.variant});
    }
    PlannedDays& row = rows[at->second];
    ++row.days;
    row.failed += failed.contains(keys[i]) ? 1 : 0;
    if (const auto result = played.find(keys[i]); result != played.end()) {
      ++row.played;
      row.timed += result->second ? 1 : 0;
      row.seconds += result->second.value_or(0.0);
    }
  }
  return rows;
}

std::string time_text(const std::optional<double>& seconds) {
  return seconds ? shown_seconds(*seconds) : "not known";
}

}  // namespace

std::string sweep_plan(const Sweep& sweep, const std::vector<std::string>& keys,
                       const std::map<std::string, std::optional<double>>& played,
                       const std::map<std::string, std::string>& failed, int jobs) {
  std::vector<std::vector<std::string>> table = {
      {"scenario", "variant", "days", "played", "left", "failed", "seconds a day", "time left"}};
  PlannedDays all;
  std::optional<double> to_come = 0.0;
  for (const PlannedDays& row : planned(sweep, keys, played, failed)) {
    const auto time = row.to_come(jobs);
    table.push_back({row.scenario, row.variant, std::to_string(row.days), std::to_string(row.played),
                     std::to_string(row.left()), std::to_string(row.failed),
                     row.timed > 0 ? fixed(row.seconds / row.timed, 1) : "", time_text(time)});
    all.days += row.days;
    all.played += row.played;
    all.failed += row.failed;
    to_come = to_come && time ? std::optional(*to_come + *time) : std::nullopt;
  }
  return aligned(table, 2) + std::to_string(all.days) + " days, " + std::to_string(all.left()) + " left" +
         (all.failed > 0 ? ", of which " + std::to_string(all.failed) + " failed" : "") + "; with " +
         std::to_string(jobs) + " at a time: " + time_text(to_come) +
         (to_come ? "" : " before a day of each variant is played") + "\n";
}

}  // namespace evbal
