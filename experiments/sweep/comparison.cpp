#include "experiments/sweep/comparison.hpp"

#include "common/error.hpp"
#include "experiments/metrics/front.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace evbal {
namespace {

/// What the days of a comparison share.
using Occasion = std::tuple<std::string, std::string, std::uint64_t>;

Occasion occasion_of(const FinishedDay& day) {
  return {day.faults, day.day, day.seed};
}

/// A point of a variant on a day and seed beside the reference's; or the mean of several.
struct Pair {
  double at = 0.0;
  double value = 0.0;
  double reference = 0.0;
  double relative = 0.0;

  Pair& operator+=(const Pair& other) {
    at += other.at;
    value += other.value;
    reference += other.reference;
    relative += other.relative;
    return *this;
  }
  Pair operator/(double divisor) const {
    return {at / divisor, value / divisor, reference / divisor, relative / divisor};
  }
};

/// The pairs of one row by occasion, none where the point lies outside.
using Pairs = std::map<Occasion, std::vector<Pair>>;

void check_metric(const std::string& name) {
  const auto names = metric_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw bad_input("`" + name + "` is no metric" + did_you_mean(name, names) + "; see docs/metrics.md");
  }
}

std::map<Occasion, std::vector<FrontPoint>> fronts_of(const std::vector<FinishedDay>& days, const Question& question) {
  std::map<Occasion, std::vector<FrontPoint>> fronts;
  std::set<std::string> variants;
  for (const auto& day : days) {
    variants.insert(day.variant);
    if (day.variant == question.reference) {
      fronts[occasion_of(day)].push_back(
          {question.at ? day.totals.at(*question.at) : 0.0, day.totals.at(question.metric)});
    }
  }
  if (fronts.empty()) {
    const std::vector<std::string> names(variants.begin(), variants.end());
    throw bad_input("no variant is called `" + question.reference + "`" + did_you_mean(question.reference, names));
  }
  if (!question.at && fronts.begin()->second.size() > 1) {
    throw bad_input("variant `" + question.reference +
                    "` has several settings; give a metric at whose equal values to compare, such as `--at idle_km`");
  }
  return fronts;
}

/// Paths that take more than one value in a variant.
std::set<std::string> varied(const std::vector<FinishedDay>& days, const std::string& variant) {
  std::map<std::string, std::set<std::string>> values;
  for (const auto& day : days) {
    if (day.variant == variant) {
      for (const auto& [path, value] : day.settings) {
        values[path].insert(value);
      }
    }
  }
  std::set<std::string> paths;
  for (const auto& [path, taken] : values) {
    if (taken.size() > 1) {
      paths.insert(path);
    }
  }
  return paths;
}

std::string label(const FinishedDay& day, const std::set<std::string>& paths) {
  std::string text;
  for (const auto& path : paths) {
    text += (text.empty() ? "" : " ") + path + "=" + day.settings.at(path);
  }
  return text.empty() ? "as given" : text;
}

/// One row from its pairs, those of one occasion averaged first.
Compared summed_up(Compared row, const Pairs& pairs) {
  Pair sum;
  std::vector<DayValue> relative;
  for (const auto& [occasion, of_occasion] : pairs) {
    if (of_occasion.empty()) {
      ++row.outside;
      continue;
    }
    const Pair mean = std::accumulate(of_occasion.begin(), of_occasion.end(), Pair{},
                                      [](Pair total, const Pair& pair) { return total += pair; }) /
                      static_cast<double>(of_occasion.size());
    sum += mean;
    relative.push_back({std::get<1>(occasion), mean.relative});
  }
  row.pairs = static_cast<int>(relative.size());
  if (!relative.empty()) {
    sum = sum / static_cast<double>(relative.size());
    row.at = sum.at;
    row.value = sum.value;
    row.reference = sum.reference;
    row.by_t = t_interval(relative);
    row.by_bootstrap = bootstrap_interval(relative);
  }
  return row;
}

/// The point of `day` beside the reference's front; nothing if it lies outside.
std::vector<Pair> paired(const FinishedDay& day, const std::vector<FrontPoint>& front, const Question& question) {
  const double at = question.at ? day.totals.at(*question.at) : 0.0;
  const auto reference = value_at(front, at);
  if (!reference) {
    return {};
  }
  if (*reference == 0.0) {
    throw bad_input("`" + question.metric + "` of " + question.reference + " is 0 on " + day.day + ", seed " +
                    std::to_string(day.seed) + ": no difference is relative to that; compare another metric");
  }
  const double value = day.totals.at(question.metric);
  return {{at, value, *reference, value / *reference - 1.0}};
}

/// The rows of one variant under one schedule of faults.
std::vector<Compared> compare_variant(const std::vector<FinishedDay>& days,
                                      const std::map<Occasion, std::vector<FrontPoint>>& fronts, const Compared& start,
                                      const Question& question) {
  const std::set<std::string> paths = varied(days, start.variant);
  std::vector<std::string> points;
  std::map<std::string, Pairs> by_point;
  Pairs together;
  for (const auto& day : days) {
    if (day.variant == start.variant && day.faults == start.faults) {
      const std::string point = label(day, paths);
      if (!by_point.contains(point)) {
        points.push_back(point);
      }
      const auto pair = paired(day, fronts.at(occasion_of(day)), question);
      by_point[point][occasion_of(day)] = pair;
      auto& all = together[occasion_of(day)];
      all.insert(all.end(), pair.begin(), pair.end());
    }
  }
  std::vector<Compared> rows;
  for (const auto& point : points) {
    rows.push_back(start);
    rows.back().settings = point;
    rows.back() = summed_up(rows.back(), by_point.at(point));
  }
  if (points.size() > 1) {
    rows.push_back(summed_up(start, together));
  }
  return rows;
}

}  // namespace

std::vector<Compared> compare(const std::vector<FinishedDay>& days, const Question& question) {
  check_metric(question.metric);
  check_metric(question.at.value_or(question.metric));
  const auto fronts = fronts_of(days, question);
  std::vector<Compared> rows;
  std::set<std::pair<std::string, std::string>> seen;
  for (const auto& day : days) {
    if (day.variant != question.reference && seen.emplace(day.faults, day.variant).second) {
      const auto more = compare_variant(days, fronts, {.faults = day.faults, .variant = day.variant}, question);
      rows.insert(rows.end(), more.begin(), more.end());
    }
  }
  return rows;
}

}  // namespace evbal
