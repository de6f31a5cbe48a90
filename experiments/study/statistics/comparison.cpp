#include "experiments/study/statistics/comparison.hpp"

#include "common/error.hpp"
#include "experiments/study/statistics/front.hpp"
#include "experiments/study/statistics/known_names.hpp"
#include "experiments/study/statistics/replication.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace evbal {
namespace {

/// A point of a variant on a day and seed beside the reference's; or the mean of several.
struct Pair {
  double at = 0.0;
  double value = 0.0;
  double reference = 0.0;
  double relative = 0.0;  ///< not a number if a reference is 0

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

/// The pairs of one row by replication, none where the point lies outside.
using Pairs = std::map<Replication, std::vector<Pair>>;

/// The reference's settings on one replication.
struct Reference {
  std::vector<FrontPoint> front;
  std::map<std::string, std::string> settings;  ///< of the last one, its controller too
};

/// The settings of a day, among which its controller.
std::map<std::string, std::string> settings_of(const FinishedDay& day) {
  auto settings = day.settings;
  settings["controller"] = day.controller;
  return settings;
}

using References = std::map<Replication, Reference>;

References references_of(const std::vector<FinishedDay>& days, const Question& question) {
  expect_variant(question.reference, days);
  References references;
  for (const auto& day : days) {
    if (day.variant == question.reference) {
      auto& reference = references[replication_of(day)];
      reference.front.push_back({question.at ? day.totals.at(*question.at) : 0.0, day.totals.at(question.metric)});
      reference.settings = settings_of(day);
    }
  }
  if (!question.at && references.begin()->second.front.size() > 1) {
    throw bad_input("variant `" + question.reference +
                    "` has several settings; give a metric at whose equal values to compare, such as `--at idle_km`");
  }
  return references;
}

/// Paths that take more than one value.
std::set<std::string> varied(const std::vector<const FinishedDay*>& days) {
  std::map<std::string, std::set<std::string>> values;
  for (const auto* day : days) {
    for (const auto& [path, value] : day->settings) {
      values[path].insert(value);
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

/// Paths in which a day differs from a reference that has one setting.
std::set<std::string> switched(const FinishedDay& day, const Reference& reference) {
  std::set<std::string> paths;
  for (const auto& [path, value] : settings_of(day)) {
    if (reference.front.size() == 1 && reference.settings.at(path) != value) {
      paths.insert(path);
    }
  }
  return paths;
}

std::string label(const FinishedDay& day, const std::set<std::string>& paths) {
  std::string text;
  for (const auto& path : paths) {
    const std::string value = settings_of(day).at(path);
    text += (text.empty() ? "" : " ") + path + "=" + (value.empty() ? "default" : value);
  }
  return text.empty() ? "as given" : text;
}

/// One row from its pairs, those of one replication averaged first.
Compared summed_up(Compared row, const Pairs& pairs) {
  Pair sum;
  std::vector<DayValue> absolute;
  std::vector<DayValue> relative;
  for (const auto& [replication, of_replication] : pairs) {
    if (of_replication.empty()) {
      ++row.outside;
      continue;
    }
    const Pair mean = std::accumulate(of_replication.begin(), of_replication.end(), Pair{},
                                      [](Pair total, const Pair& pair) { return total += pair; }) /
                      static_cast<double>(of_replication.size());
    sum += mean;
    absolute.push_back({std::get<2>(replication), mean.value - mean.reference});
    relative.push_back({std::get<2>(replication), mean.relative});
  }
  row.pairs = static_cast<int>(relative.size());
  if (row.pairs == 0) {
    return row;
  }
  sum = sum / static_cast<double>(relative.size());
  row.at = sum.at;
  row.value = sum.value;
  row.reference = sum.reference;
  row.difference = t_interval(absolute);
  row.relative = !std::isnan(sum.relative);
  if (row.relative) {
    row.by_t = t_interval(relative);
    row.by_bootstrap = bootstrap_interval(relative);
  }
  row.p = t_test(row.relative ? relative : absolute);
  return row;
}

/// The point of `day` beside the reference's front; nothing if it lies outside.
std::vector<Pair> paired(const FinishedDay& day, const std::vector<FrontPoint>& front, const Question& question) {
  const double at = question.at ? day.totals.at(*question.at) : 0.0;
  const auto reference = value_at(front, at);
  if (!reference) {
    return {};
  }
  const double value = day.totals.at(question.metric);
  const double relative = *reference == 0.0 ? std::numeric_limits<double>::quiet_NaN() : value / *reference - 1.0;
  return {{at, value, *reference, relative}};
}

/// The rows of one variant in one scenario under one schedule of faults: `days`, of which there is one at least.
std::vector<Compared> compare_variant(const std::vector<const FinishedDay*>& days, const References& references,
                                      const Question& question) {
  const Compared start{
      .scenario = days.front()->scenario, .faults = days.front()->faults, .variant = days.front()->variant};
  const std::set<std::string> own = varied(days);
  std::vector<std::string> points;
  std::map<std::string, Pairs> by_point;
  Pairs together;
  for (const auto* day : days) {
    const Replication replication = replication_of(*day);
    const auto reference = references.find(replication);
    if (reference == references.end()) {
      continue;
    }
    std::set<std::string> paths = switched(*day, reference->second);
    paths.insert(own.begin(), own.end());
    const std::string point = label(*day, paths);
    if (!by_point.contains(point)) {
      points.push_back(point);
    }
    const auto pair = paired(*day, reference->second.front, question);
    by_point[point][replication] = pair;
    auto& all = together[replication];
    all.insert(all.end(), pair.begin(), pair.end());
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
  expect_metric(question.metric, days);
  expect_metric(question.at.value_or(question.metric), days);
  const References references = references_of(days, question);
  using Group = std::tuple<std::string, std::string, std::string>;
  std::vector<Group> groups;
  std::map<Group, std::vector<const FinishedDay*>> by_group;
  for (const auto& day : days) {
    if (day.variant != question.reference) {
      const Group group{day.scenario, day.faults, day.variant};
      if (!by_group.contains(group)) {
        groups.push_back(group);
      }
      by_group[group].push_back(&day);
    }
  }
  std::vector<Compared> rows;
  for (const auto& group : groups) {
    const auto more = compare_variant(by_group.at(group), references, question);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  adjust(rows);
  return rows;
}

void adjust(std::vector<Compared>& rows) {
  std::vector<double> p;
  for (const auto& row : rows) {
    if (row.pairs > 0) {
      p.push_back(row.p);
    }
  }
  const std::vector<double> adjusted = holm(p);
  auto next = adjusted.begin();
  for (auto& row : rows) {
    row.p_holm = row.pairs > 0 ? *next++ : 1.0;
  }
}

}  // namespace evbal
