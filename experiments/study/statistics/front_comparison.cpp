#include "experiments/study/statistics/front_comparison.hpp"

#include "common/contract.hpp"
#include "experiments/study/statistics/known_names.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace evbal {
namespace {

/// So that a day without any lost passengers has a logarithm too.
constexpr double half = 0.5;

/// The mean of ln(x) from `a` to `b`, both positive: (b ln b - a ln a) / (b - a) - 1.
double mean_log(double a, double b) {
  const double middle = (a + b) / 2.0;
  const double lean = (b - a) / (2.0 * middle);
  if (std::abs(lean) < 1e-4) {
    return std::log(middle) - lean * lean / 6.0;  // the next term is below 1e-17
  }
  return (b * std::log(b) - a * std::log(a)) / (b - a) - 1.0;
}

/// The corners of both hulls within [from, to], and these.
std::vector<double> corners_of(const std::vector<FrontPoint>& hull, const std::vector<FrontPoint>& reference,
                               double from, double to) {
  std::set<double> corners{from, to};
  for (const auto* points : {&hull, &reference}) {
    for (const FrontPoint& point : *points) {
      if (from < point.cost && point.cost < to) {
        corners.insert(point.cost);
      }
    }
  }
  return {corners.begin(), corners.end()};
}

/// The mean of a hull from the first of the corners to the last, which it covers; its value there if there is one.
double mean_value(const std::vector<FrontPoint>& hull, const std::vector<double>& corners) {
  if (corners.size() == 1) {
    return *value_at(hull, corners.front());
  }
  double area = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    area += (corners[i] - corners[i - 1]) * (*value_at(hull, corners[i - 1]) + *value_at(hull, corners[i])) / 2.0;
  }
  return area / (corners.back() - corners.front());
}

using Settings = std::map<std::string, std::string>;
using Points = std::map<Settings, std::vector<FrontPoint>>;  ///< several of a setting are corners of a bound
using Seeds = std::map<std::uint64_t, Points>;
using Dates = std::map<std::string, Seeds>;

/// The seeds that all of them have.
std::vector<std::uint64_t> shared_seeds(const Seeds& first, std::initializer_list<const Seeds*> others) {
  std::vector<std::uint64_t> seeds;
  for (const auto& [seed, points] : first) {
    if (std::ranges::all_of(others, [&, seed = seed](const Seeds* other) { return other->contains(seed); })) {
      seeds.push_back(seed);
    }
  }
  return seeds;
}

/// The settings that were played with all the seeds, each summed over these.
std::vector<FrontPoint> summed(const Seeds& played, const std::vector<std::uint64_t>& seeds) {
  std::vector<FrontPoint> front;
  for (const auto& [settings, points] : played.at(seeds.front())) {
    FrontPoint sum;
    const bool everywhere = std::all_of(seeds.begin(), seeds.end(), [&](std::uint64_t seed) {
      const auto found = played.at(seed).find(settings);
      if (found == played.at(seed).end()) {
        return false;
      }
      sum.cost += found->second.front().cost;
      sum.value += found->second.front().value;
      return true;
    });
    if (everywhere) {
      front.push_back(sum);
    }
  }
  return front;
}

/// The gap between two fronts of a day with these seeds.
std::optional<FrontGap> gap_of(const Seeds& variant, const Seeds& reference, const std::vector<std::uint64_t>& seeds) {
  const auto front = summed(variant, seeds);
  const auto other = summed(reference, seeds);
  return front_gap(lower_hull(front), lower_hull(other), front.size() == 1 || other.size() == 1);
}

/// How far it is from a reference to the bound, and how much of that was gone.
struct Way {
  double gone = 0.0;
  double whole = 0.0;
};

/// Adds a day's way, with the seeds that have a bound, if that covers the gap. To the right of its last corner a bound
/// stays as it is.
void add_way(const Seeds& variant, const Seeds& reference, const Seeds& bounds, std::optional<Way>& way) {
  const auto seeds = shared_seeds(variant, {&reference, &bounds});
  const auto gap = seeds.empty() ? std::nullopt : gap_of(variant, reference, seeds);
  if (!gap) {
    return;
  }
  std::vector<std::vector<FrontPoint>> hulls;
  for (const std::uint64_t seed : seeds) {
    hulls.push_back(lower_hull(bounds.at(seed).begin()->second));
  }
  std::vector<FrontPoint> bound = least_sum(hulls);
  if (bound.front().cost > gap->from) {
    return;
  }
  if (bound.back().cost < gap->to) {
    bound.push_back({gap->to, bound.back().value});
  }
  const double possible = mean_value(bound, corners_of(bound, bound, gap->from, gap->to));
  way = way.value_or(Way{});
  way->gone += gap->reference - gap->value;
  way->whole += gap->reference - possible;
}

ComparedFronts compare_variant(ComparedFronts row, const Dates& variant, const Dates& reference, const Dates& bounds) {
  std::vector<DayValue> log_ratios;
  std::optional<Way> way;
  for (const auto& [date, played] : variant) {
    const auto beside = reference.find(date);
    const auto seeds =
        beside == reference.end() ? std::vector<std::uint64_t>() : shared_seeds(played, {&beside->second});
    if (seeds.empty()) {
      continue;
    }
    const auto gap = gap_of(played, beside->second, seeds);
    if (!gap) {
      ++row.apart;
      continue;
    }
    log_ratios.push_back({date, gap->log_ratio});
    row.covered += gap->covered;
    row.value += gap->value;
    row.reference += gap->reference;
    if (const auto bound = bounds.find(date); bound != bounds.end()) {
      add_way(played, beside->second, bound->second, way);
    }
  }
  row.days = static_cast<int>(log_ratios.size());
  if (row.days > 0) {
    row.covered /= row.days;
    const Interval log_ratio = t_interval(log_ratios);
    row.ratio = {std::exp(log_ratio.mean) - 1.0, std::exp(log_ratio.low) - 1.0, std::exp(log_ratio.high) - 1.0};
    row.p = t_test(log_ratios);
  }
  if (way && way->whole > 0.0) {
    row.way = way->gone / way->whole;
  }
  return row;
}

}  // namespace

std::optional<FrontGap> front_gap(const std::vector<FrontPoint>& hull, const std::vector<FrontPoint>& reference,
                                  bool frozen) {
  if (hull.empty() || reference.empty()) {
    return std::nullopt;
  }
  FrontGap gap;
  gap.from = std::max(hull.front().cost, reference.front().cost);
  gap.to = std::min(hull.back().cost, reference.back().cost);
  if (gap.from > gap.to || (gap.from == gap.to && !frozen)) {
    return std::nullopt;
  }
  const auto corners = corners_of(hull, reference, gap.from, gap.to);
  gap.value = mean_value(hull, corners);
  gap.reference = mean_value(reference, corners);
  EVBAL_EXPECT(hull.back().value >= 0.0 && reference.back().value >= 0.0, "values that are not negative");
  if (gap.from == gap.to) {
    gap.log_ratio = std::log((gap.value + half) / (gap.reference + half));
    gap.covered = reference.size() == 1 ? 1.0 : 0.0;
    return gap;
  }
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const auto log_of = [&](const std::vector<FrontPoint>& front) {
      return mean_log(*value_at(front, corners[i - 1]) + half, *value_at(front, corners[i]) + half);
    };
    gap.log_ratio += (corners[i] - corners[i - 1]) * (log_of(hull) - log_of(reference));
  }
  gap.log_ratio /= gap.to - gap.from;
  gap.covered = (gap.to - gap.from) / (reference.back().cost - reference.front().cost);
  return gap;
}

std::vector<ComparedFronts> compare_fronts(const std::vector<FinishedDay>& days, const FrontQuestion& question) {
  expect_metric(question.metric, days);
  expect_metric(question.at, days);
  expect_variant(question.reference, days);
  using Group = std::tuple<std::string, std::string, std::string>;  // scenario, faults, variant
  std::map<Group, Dates> groups;
  std::vector<Group> in_order;
  for (const FinishedDay& day : days) {
    const Group group{day.scenario, day.faults, day.variant};
    if (!groups.contains(group)) {
      in_order.push_back(group);
    }
    groups[group][day.day][day.seed][day.settings].push_back(
        {day.totals.at(question.at), day.totals.at(question.metric)});
  }
  std::vector<ComparedFronts> rows;
  for (const auto& group : in_order) {
    const auto& [scenario, faults, variant] = group;
    const auto reference = groups.find({scenario, faults, question.reference});
    if (variant == question.reference || variant == question.bound || reference == groups.end()) {
      continue;
    }
    const auto bounds = groups.find({scenario, faults, question.bound.value_or("")});
    rows.push_back(compare_variant({.scenario = scenario, .faults = faults, .variant = variant}, groups.at(group),
                                   reference->second, bounds == groups.end() ? Dates() : bounds->second));
  }
  return rows;
}

}  // namespace evbal
