#include "experiments/study/statistics/comparison.hpp"

#include "common/error.hpp"
#include "common/suggestion.hpp"
#include "experiments/study/design/trade.hpp"
#include "experiments/study/statistics/front_gap.hpp"
#include "experiments/study/statistics/known_names.hpp"
#include "experiments/study/statistics/variant_days.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace evbal {
namespace {

/// A variant in one scenario under one schedule of faults.
struct VariantGroup {
  std::string scenario;
  std::string faults;
  std::string variant;
  std::vector<Settings> settings{};  ///< in the order of the sweep
  VariantDays days{};
};

std::vector<VariantGroup> variant_groups(const std::vector<FinishedDay>& days, const ReadMetrics& read) {
  std::vector<VariantGroup> groups;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> positions;
  for (const FinishedDay& day : days) {
    const auto [at, is_new] = positions.emplace(std::tuple(day.scenario, day.faults, day.variant), groups.size());
    if (is_new) {
      groups.push_back({day.scenario, day.faults, day.variant});
    }
    VariantGroup& group = groups[at->second];
    if (std::find(group.settings.begin(), group.settings.end(), settings_of(day)) == group.settings.end()) {
      group.settings.push_back(settings_of(day));
    }
    add_day(group.days, day, read);
  }
  return groups;
}

/// The paths in which these differ.
std::set<std::string> differing(const std::vector<Settings>& all) {
  std::map<std::string, std::set<std::string>> values;
  for (const Settings& settings : all) {
    for (const auto& [path, value] : settings) {
      values[path].insert(value);
    }
  }
  std::erase_if(values, [](const auto& path) { return path.second.size() == 1; });
  std::set<std::string> paths;
  for (const auto& [path, taken] : values) {
    paths.insert(path);
  }
  return paths;
}

/// A setting by what the variant varies, and in what it differs from a reference that has one setting.
std::string label(const Settings& settings, const VariantGroup& variant, const VariantGroup& reference) {
  std::set<std::string> paths = differing(variant.settings);
  if (reference.settings.size() == 1) {
    paths.merge(differing({settings, reference.settings.front()}));
  }
  std::string text;
  for (const auto& path : paths) {
    const auto found = settings.find(path);
    const std::string value = found == settings.end() ? "" : found->second;
    text += (text.empty() ? "" : " ") + path + "=" + (value.empty() ? "default" : value);
  }
  return text.empty() ? "as given" : text;
}

/// What a row is made from.
struct Sides {
  const VariantGroup& variant;
  const VariantGroup& reference;
  const VariantGroup* bound;  ///< none: not known
  const Settings* chosen;     ///< none: all settings of the variant
  bool adds_up;               ///< the metric
  bool against_bound;         ///< the reference is the bound
};

/// Both sides on one day, over the seeds that both have.
struct DayFronts {
  DayTotals settings;                   ///< of the variant, those that are compared
  std::vector<FrontPoint> front{};      ///< of these
  std::vector<FrontPoint> reference{};  ///< its front
  bool frozen = false;                  ///< whether either is a single setting

  std::optional<FrontGap> gap() const { return front_gap(front, reference, frozen); }
};

DayFronts day_fronts(const Sides& sides, const SeedTotals& own, const SeedTotals& other,
                     const std::vector<std::uint64_t>& seeds) {
  DayFronts day{.settings = summed(own, seeds)};
  if (sides.chosen != nullptr) {
    std::erase_if(day.settings, [&](const auto& one) { return one.first != *sides.chosen; });
  }
  const double divisor = sides.adds_up ? 1.0 : static_cast<double>(seeds.size());
  day.front = front_of(day.settings, divisor);
  day.frozen = day.settings.size() == 1;
  if (sides.against_bound) {
    day.reference = bound_front(other, seeds, day.front.empty() ? 0.0 : day.front.back().cost);
  } else {
    const DayTotals totals = summed(other, seeds);
    day.reference = front_of(totals, divisor);
    day.frozen = day.frozen || totals.size() == 1;
  }
  return day;
}

/// How far it is from the reference to the bound, and how much of that was gone.
struct Way {
  double gone = 0.0;
  double whole = 0.0;
  int days = 0;
};

/// Adds a day's way, over the seeds that have a bound, if the bound reaches to the least cost that both cover.
void add_way(const Sides& sides, const SeedTotals& own, const SeedTotals& other, const SeedTotals& bounds,
             std::optional<Way>& way) {
  std::vector<std::uint64_t> seeds = shared_seeds(own, other);
  std::erase_if(seeds, [&](std::uint64_t seed) { return !bounds.contains(seed); });
  const auto gap = seeds.empty() ? std::nullopt : day_fronts(sides, own, other, seeds).gap();
  if (!gap) {
    return;
  }
  const std::vector<FrontPoint> bound = bound_front(bounds, seeds, gap->to);
  if (bound.front().cost > gap->from) {
    return;
  }
  way = way.value_or(Way{});
  ++way->days;
  way->gone += gap->reference - gap->value;
  way->whole += gap->reference - mean_value(bound, gap->from, gap->to);
}

/// Adds a day to the sums of a row; gives the day's result, if there is one.
std::optional<double> add_to(Compared& row, const Sides& sides, const std::string& date, const DayFronts& day,
                             std::size_t seeds) {
  for (const auto& [settings, sum] : day.settings) {
    ++row.points;
    row.inside += value_at(day.reference, sum.cost) ? 1 : 0;
  }
  const auto gap = day.gap();
  if (!gap) {
    ++row.apart;
    return std::nullopt;
  }
  const auto count = static_cast<double>(seeds);
  ++row.days;
  row.from += gap->from / count;
  row.to += gap->to / count;
  row.covered += gap->covered;
  row.value += gap->value;
  row.reference += gap->reference;
  const double divisor = sides.adds_up ? count : 1.0;
  row.by_day.push_back({date, gap->value / divisor, gap->reference / divisor});
  return row.relative ? mean_log_ratio(day.front, day.reference, *gap) : (gap->value - gap->reference) / divisor;
}

/// Sums over days as means, and the days' results as an interval.
void conclude(Compared& row, const Sides& sides, const std::vector<DayValue>& results) {
  std::vector<double*> sums = {&row.from, &row.to, &row.covered};
  if (!sides.adds_up) {
    sums.insert(sums.end(), {&row.value, &row.reference});
  }
  for (double* sum : sums) {
    *sum /= row.days;
  }
  row.difference = t_interval(results);
  row.p = t_test(results);
  if (row.relative) {
    for (double* end : {&row.difference.mean, &row.difference.low, &row.difference.high}) {
      *end = std::isfinite(*end) ? std::exp(*end) - 1.0 : *end;
    }
  }
}

Compared row_of(const Sides& sides) {
  Compared row{.scenario = sides.variant.scenario,
               .faults = sides.variant.faults,
               .variant = sides.variant.variant,
               .whole = sides.chosen == nullptr,
               .relative = sides.adds_up && !sides.against_bound};
  std::vector<DayValue> results;
  std::optional<Way> way;
  for (const auto& [date, own] : sides.variant.days) {
    const auto other = sides.reference.days.find(date);
    const auto seeds =
        other == sides.reference.days.end() ? std::vector<std::uint64_t>() : shared_seeds(own, other->second);
    const DayFronts day = seeds.empty() ? DayFronts{} : day_fronts(sides, own, other->second, seeds);
    if (day.front.empty() || day.reference.empty()) {
      continue;
    }
    if (const auto result = add_to(row, sides, date, day, seeds.size())) {
      results.push_back({date, *result});
    }
    if (sides.bound != nullptr && sides.bound->days.contains(date)) {
      add_way(sides, own, other->second, sides.bound->days.at(date), way);
    }
  }
  if (row.days > 0) {
    conclude(row, sides, results);
  }
  if (way && way->whole > 0.0) {
    row.way = way->gone / way->whole;
    row.way_days = way->days;
  }
  return row;
}

/// The rows of a variant.
void add_rows(Sides sides, bool fronts, std::vector<Compared>& rows) {
  const std::vector<Settings>& settings = sides.variant.settings;
  for (const Settings& one : settings) {
    sides.chosen = settings.size() > 1 ? &one : nullptr;
    rows.push_back(row_of(sides));
    rows.back().settings = label(one, sides.variant, sides.reference);
  }
  if (settings.size() > 1 && fronts) {
    sides.chosen = nullptr;
    rows.push_back(row_of(sides));
  }
}

ReadMetrics metrics_of(const Question& question, const std::vector<FinishedDay>& days) {
  expect_metric(question.metric, days);
  if (!question.at) {
    return {question.metric};
  }
  const auto traded = traded_for(*question.at);
  if (!traded) {
    throw bad_input("`" + *question.at + "` is nothing to compare at" + did_you_mean(*question.at, traded_metrics()) +
                    "; `idle_km` and `lost` are, which controllers trade, also `_after_7`");
  }
  expect_metric(*question.at, days);
  return {question.metric, *question.at, *traded};
}

const VariantGroup* group_like(const std::vector<VariantGroup>& groups, const VariantGroup& like,
                               const std::optional<std::string>& variant) {
  const auto found = std::find_if(groups.begin(), groups.end(), [&](const VariantGroup& group) {
    return group.scenario == like.scenario && group.faults == like.faults && group.variant == variant;
  });
  return found == groups.end() ? nullptr : &*found;
}

}  // namespace

std::optional<double> of_totals(const Compared& row) {
  return row.relative && row.reference > 0.0 ? std::optional(row.value / row.reference - 1.0) : std::nullopt;
}

std::vector<Compared> compare(const std::vector<FinishedDay>& days, const Question& question) {
  const ReadMetrics read = metrics_of(question, days);
  expect_variant(question.reference, days);
  const std::vector<VariantGroup> groups = variant_groups(days, read);
  std::vector<Compared> rows;
  for (const VariantGroup& group : groups) {
    const VariantGroup* reference = group_like(groups, group, question.reference);
    if (group.variant == question.reference || group.variant == question.bound || reference == nullptr) {
      continue;
    }
    if (!question.at && reference->settings.size() > 1) {
      throw bad_input("variant `" + question.reference +
                      "` has several settings; give a metric at whose equal values to compare, such as `--at idle_km`");
    }
    add_rows({.variant = group,
              .reference = *reference,
              .bound = group_like(groups, group, question.bound),
              .chosen = nullptr,
              .adds_up = adds_up(question.metric),
              .against_bound = question.reference == question.bound},
             question.at.has_value(), rows);
  }
  return rows;
}

}  // namespace evbal
