#include "experiments/study/statistics/study_figures.hpp"

#include <limits>
#include <utility>

namespace evbal {
namespace {

/// The metric's mean a day, or its share of what `of` comes to on all days together; none without days, or if that is
/// nothing.
std::optional<Interval> bar_value(const std::vector<const FinishedDay*>& days, const std::string& metric,
                                  const std::optional<std::string>& of) {
  if (!of) {
    return days.empty() ? std::nullopt : std::optional(mean_over_days(days, metric));
  }
  double part = 0.0;
  double whole = 0.0;
  for (const FinishedDay* day : days) {
    part += day->totals.at(metric);
    whole += day->totals.at(*of);
  }
  constexpr double unknown = std::numeric_limits<double>::infinity();
  return whole == 0.0 ? std::nullopt : std::optional(Interval{part / whole, -unknown, unknown});
}

std::string bar_words(const Page& page, const PageFigure& figure, const std::string& variant,
                      const std::string& metric) {
  const std::string words = words_for(page, variant);
  return figure.metrics.size() == 1 ? words : figure.variants.size() == 1 ? metric : words + ", " + metric;
}

BarGroup bar_group(const Page& page, const PageFigure& figure, const PageDays& days, const std::string& scenario,
                   const std::string& faults) {
  BarGroup group{.title =
                     (figure.scenarios.size() > 1 ? words_for(page, scenario) + ", " : "") + words_for(page, faults)};
  for (const std::string& variant : figure.variants) {
    std::vector<const FinishedDay*> played;
    for (const FinishedDay& day : days.days) {
      if (day.variant == variant && day.scenario == scenario && day.faults == faults) {
        played.push_back(&day);
      }
    }
    for (const std::string& metric : figure.metrics) {
      if (const auto value = bar_value(played, metric, figure.of)) {
        group.bars.push_back({bar_words(page, figure, variant, metric), *value});
      }
    }
  }
  return group;
}

}  // namespace

std::vector<BarGroup> bar_groups(const Page& page, const PageFigure& figure, const PageDays& days) {
  std::vector<BarGroup> groups;
  for (const std::string& scenario : figure.scenarios) {
    for (const std::string& faults : figure.faults) {
      BarGroup group = bar_group(page, figure, days, scenario, faults);
      if (!group.bars.empty()) {
        groups.push_back(std::move(group));
      }
    }
  }
  return groups;
}

}  // namespace evbal
