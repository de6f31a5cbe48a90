#include "experiments/study/statistics/study_figures.hpp"
#include "experiments/study/statistics/variant_days.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace evbal {
namespace {

/// What a setting came to, day by day.
struct SettingDays {
  std::vector<DayValue> km{};
  std::vector<DayValue> lost{};
};

FrontLine front_line(std::string name, const std::map<Settings, SettingDays>& settings) {
  FrontLine line{.name = std::move(name)};
  for (const auto& [setting, of_days] : settings) {
    line.points.push_back({t_interval(of_days.km).mean, t_interval(of_days.lost).mean});
  }
  if (settings.size() == 1) {
    line.km = t_interval(settings.begin()->second.km);
    line.lost = t_interval(settings.begin()->second.lost);
  }
  line.hull = lower_hull(line.points);
  std::sort(line.points.begin(), line.points.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  return line;
}

/// On which days and seeds the bound is known.
std::string bound_note(const MeanBound& bound) {
  if (bound.days == 0) {
    return "No bound was computed.";
  }
  if (bound.front.empty()) {
    return "Bound of " + std::to_string(bound.days) + " of " + std::to_string(bound.of_days) + " days only: not drawn.";
  }
  return bound.seeds == bound.of_seeds
             ? ""
             : "Bound of " + std::to_string(bound.seeds) + " of " + std::to_string(bound.of_seeds) + " days and seeds.";
}

}  // namespace

FrontPanel front_panel(const Page& page, const PageFigure& figure, const std::string& scenario, const PageDays& days) {
  FrontPanel panel{.title = words_for(page, scenario)};
  for (const std::string& variant : figure.variants) {
    std::map<Settings, SettingDays> settings;
    for (const FinishedDay& day : days.days) {
      if (day.variant == variant && day.scenario == scenario && day.faults == figure.faults.front()) {
        SettingDays& setting = settings[settings_of(day)];
        setting.km.push_back({day.day, day.totals.at("idle_km")});
        setting.lost.push_back({day.day, day.totals.at("lost")});
      }
    }
    if (!settings.empty()) {
      panel.lines.push_back(front_line(words_for(page, variant), settings));
    }
  }
  const MeanBound bound = mean_bound(days, scenario, figure.faults.front());
  panel.bound = bound.front;
  panel.note = bound_note(bound);
  return panel;
}

}  // namespace evbal
