#include "experiments/study/statistics/variant_days.hpp"

#include <algorithm>
#include <iterator>

namespace evbal {

std::vector<FinishedDay> days_of(const std::vector<FinishedDay>& days, const std::vector<std::string>& variants) {
  std::vector<FinishedDay> some;
  std::copy_if(days.begin(), days.end(), std::back_inserter(some), [&](const FinishedDay& day) {
    return std::find(variants.begin(), variants.end(), day.variant) != variants.end();
  });
  return some;
}

Settings settings_of(const FinishedDay& day) {
  Settings settings = day.settings;
  settings["controller"] = day.controller;
  return settings;
}

void add_day(VariantDays& days, const FinishedDay& day, const ReadMetrics& read) {
  const auto of = [&](const std::string& metric) { return metric.empty() ? 0.0 : day.totals.at(metric); };
  days[day.day][day.seed][settings_of(day)].push_back({of(read.cost), of(read.traded), of(read.metric)});
}

std::vector<std::uint64_t> shared_seeds(const SeedTotals& first, const SeedTotals& second) {
  std::vector<std::uint64_t> seeds;
  for (const auto& [seed, totals] : first) {
    if (second.contains(seed)) {
      seeds.push_back(seed);
    }
  }
  return seeds;
}

DayTotals summed(const SeedTotals& played, const std::vector<std::uint64_t>& seeds) {
  DayTotals sums;
  for (const auto& [settings, totals] : played.at(seeds.front())) {
    SettingTotals sum;
    const bool everywhere = std::all_of(seeds.begin(), seeds.end(), [&, &settings = settings](std::uint64_t seed) {
      const auto found = played.at(seed).find(settings);
      if (found == played.at(seed).end()) {
        return false;
      }
      const SettingTotals& more = found->second.front();
      sum = {sum.cost + more.cost, sum.traded + more.traded, sum.metric + more.metric};
      return true;
    });
    if (everywhere) {
      sums[settings] = sum;
    }
  }
  return sums;
}

std::vector<FrontPoint> front_of(const DayTotals& settings, double divisor) {
  std::vector<FrontPoint> trades;
  std::vector<FrontPoint> points;
  for (const auto& [setting, sum] : settings) {
    trades.push_back({sum.cost, sum.traded});
    points.push_back({sum.cost, sum.metric / divisor});
  }
  std::vector<FrontPoint> front;
  for (const std::size_t corner : hull_corners(trades)) {
    front.push_back(points[corner]);
  }
  return front;
}

std::vector<FrontPoint> bound_front(const SeedTotals& bounds, const std::vector<std::uint64_t>& seeds,
                                    double farthest) {
  std::vector<std::vector<FrontPoint>> hulls;
  for (const std::uint64_t seed : seeds) {
    std::vector<FrontPoint> corners;
    for (const auto& [setting, totals] : bounds.at(seed)) {
      for (const SettingTotals& sum : totals) {
        corners.push_back({sum.cost, sum.metric});
      }
    }
    hulls.push_back(lower_hull(corners));
  }
  std::vector<FrontPoint> front = least_sum(hulls);
  if (front.back().cost < farthest) {
    front.push_back({farthest, front.back().value});
  }
  return front;
}

}  // namespace evbal
