#include "experiments/study/statistics/page_days.hpp"

#include "experiments/study/statistics/markdown.hpp"
#include "experiments/study/statistics/variant_days.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace evbal {
namespace {

/// Points by day and seed.
using Corners = std::map<std::string, std::map<std::uint64_t, std::vector<FrontPoint>>>;

std::vector<FrontPoint> mean_front(const Corners& corners) {
  std::vector<std::vector<FrontPoint>> hulls;
  for (const auto& [day, seeds] : corners) {
    const double share = 1.0 / static_cast<double>(corners.size() * seeds.size());
    for (const auto& [seed, points] : seeds) {
      hulls.push_back(lower_hull(points));
      for (FrontPoint& point : hulls.back()) {
        point = {share * point.cost, share * point.value};
      }
    }
  }
  return least_sum(hulls);
}

}  // namespace

std::vector<Compared> whole_rows(const PageDays& days, const std::vector<std::string>& variants,
                                 const Question& question, const std::vector<std::string>& scenarios,
                                 const std::vector<std::string>& faults) {
  Words both = variants;
  both.push_back(question.reference);
  Question asked = question;
  std::vector<FinishedDay> some = days_of(days.days, both);
  if (question.metric == "lost" && question.at == "idle_km" && !days.bounds.empty()) {
    asked.bound = bound_variant;
    some.insert(some.end(), days.bounds.begin(), days.bounds.end());
  }
  std::erase_if(some,
                [&](const auto& day) { return !contains(scenarios, day.scenario) || !contains(faults, day.faults); });
  const bool reference =
      std::any_of(some.begin(), some.end(), [&](const auto& day) { return day.variant == question.reference; });
  std::vector<Compared> rows = reference ? compare(some, asked) : std::vector<Compared>();
  std::erase_if(rows, [](const Compared& row) { return !row.whole; });
  return rows;
}

MeanBound mean_bound(const PageDays& days, const std::string& scenario, const std::string& faults) {
  const auto here = [&](const FinishedDay& day) { return day.scenario == scenario && day.faults == faults; };
  std::set<std::string> dates;
  std::set<std::pair<std::string, std::uint64_t>> played;
  for (const FinishedDay& day : days.days) {
    if (here(day)) {
      dates.insert(day.day);
      played.emplace(day.day, day.seed);
    }
  }
  Corners corners;
  for (const FinishedDay& corner : days.bounds) {
    if (here(corner)) {
      corners[corner.day][corner.seed].push_back({corner.totals.at("idle_km"), corner.totals.at("lost")});
    }
  }
  MeanBound bound{.days = static_cast<int>(corners.size()),
                  .of_days = static_cast<int>(dates.size()),
                  .of_seeds = static_cast<int>(played.size())};
  for (const auto& [day, seeds] : corners) {
    bound.seeds += static_cast<int>(seeds.size());
  }
  if (bound.days > 0 && bound.days == bound.of_days) {
    bound.front = mean_front(corners);
  }
  return bound;
}

Interval mean_over_days(const std::vector<const FinishedDay*>& days, const std::string& metric) {
  std::vector<DayValue> values;
  values.reserve(days.size());
  for (const FinishedDay* day : days) {
    values.push_back({day->day, day->totals.at(metric)});
  }
  return t_interval(values);
}

bool has_front(const std::vector<FinishedDay>& days, const std::string& variant) {
  std::map<std::string, Settings> first;
  return std::any_of(days.begin(), days.end(), [&](const FinishedDay& day) {
    return day.variant == variant && first.emplace(day.scenario, settings_of(day)).first->second != settings_of(day);
  });
}

}  // namespace evbal
