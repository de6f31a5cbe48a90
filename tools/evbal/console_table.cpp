#include "tools/evbal/console_table.hpp"

#include "common/decimal.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>

namespace evbal {
namespace {

struct Line {
  const char* name;
  int digits;
  std::function<double(const RunResult&)> value;
};

const std::vector<Line>& lines() {
  static const std::vector<Line> all = {
      {"idle km", 0, [](const RunResult& r) { return r.totals.idle_km; }},
      {"unfairness of supply-demand ratio", 1, [](const RunResult& r) { return r.totals.unfairness.demand; }},
      {"unfairness of utilisation", 1, [](const RunResult& r) { return r.totals.unfairness.charging; }},
      {"served passengers", 0, [](const RunResult& r) { return static_cast<double>(r.totals.flows.served); }},
      {"lost passengers", 0, [](const RunResult& r) { return static_cast<double>(r.totals.flows.lost); }},
      {"lost, %", 1, [](const RunResult& r) { return 100.0 * r.totals.unserved_ratio; }},
      {"charger wait, min", 0, [](const RunResult& r) { return r.totals.charger_wait_min; }},
      {"charger wait, min per session", 1, [](const RunResult& r) { return r.totals.charger_wait_min_per_session; }},
      {"plans that fell back", 0, [](const RunResult& r) { return r.fallbacks; }},
      {"wall seconds", 0, [](const RunResult& r) { return r.wall_seconds; }},
  };
  return all;
}

/// How far plans are from those of another engine; `-` if that was not asked.
std::string difference_text(const std::optional<CrossChecked>& check) {
  if (!check) {
    return "-";
  }
  if (check->plans == 0) {
    return "unsolved";
  }
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.0e", check->difference);
  return text.data();
}

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string space(width > text.size() ? width - text.size() : 0, ' ');
  return left ? text + space : space + text;
}

}  // namespace

std::string side_by_side(const std::vector<RunResult>& results) {
  static constexpr std::size_t name_width = 35;
  static constexpr std::size_t least_width = 12;
  const auto width = [](const RunResult& result) { return std::max(least_width, result.controller.size() + 2); };
  std::string text = padded("", name_width, true);
  for (const auto& result : results) {
    text += padded(result.controller, width(result), false);
  }
  for (const auto& line : lines()) {
    text += "\n" + padded(line.name, name_width, true);
    for (const auto& result : results) {
      text += padded(fixed(line.value(result), line.digits), width(result), false);
    }
  }
  text += "\n";
  const auto checked = [](const RunResult& result) { return result.cross_check.has_value(); };
  if (std::any_of(results.begin(), results.end(), checked)) {
    text += padded("relative difference to ipopt", name_width, true);
    for (const auto& result : results) {
      text += padded(difference_text(result.cross_check), width(result), false);
    }
    text += "\n";
  }
  return text;
}

std::string cost_table(const std::vector<MetricCost>& costs) {
  std::vector<std::vector<std::string>> rows = {{"", "with", "without", "cost", "area", "back after"}};
  for (const auto& [metric, cost] : costs) {
    rows.push_back({metric, fixed(cost.with, 1), fixed(cost.without, 1), fixed(cost.cost(), 1), fixed(cost.area, 1),
                    cost.recovered ? std::to_string(*cost.recovered) + " min" : "not seen before the day ended"});
  }
  return aligned(rows, 1);
}

std::string distribution_table(const std::vector<DrawnMetric>& metrics) {
  std::vector<std::vector<std::string>> cells = {{""}};
  for (const auto& [name, value] : named(Distribution{})) {
    cells.front().push_back(name);
  }
  cells.front().emplace_back("without");
  for (const auto& metric : metrics) {
    const int digits = metric.distribution.max < 1.0 ? 4 : 1;
    cells.push_back({metric.name});
    for (const auto& [name, value] : named(metric.distribution)) {
      cells.back().push_back(fixed(value, digits));
    }
    cells.back().push_back(fixed(metric.without, digits));
  }
  return aligned(cells, 1);
}

std::string influence_table(const std::vector<Influence>& influences) {
  std::vector<std::vector<std::string>> rows = {{"fault", "what of it", "rank correlation", "95 %", "p, after Holm"}};
  for (std::size_t i = 0; i < std::min<std::size_t>(5, influences.size()); ++i) {
    const Influence& row = influences[i];
    rows.push_back({row.fault, row.quantity, fixed(row.correlation.mean, 2, true),
                    is_known(row.correlation)
                        ? fixed(row.correlation.low, 2, true) + " .. " + fixed(row.correlation.high, 2, true)
                        : "not known",
                    fixed(row.p_adjusted, 4)});
  }
  return aligned(rows, 2);
}

std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += (i == 0 ? "" : "  ") + padded(row[i], widths[i], i < left);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return text;
}

}  // namespace evbal
