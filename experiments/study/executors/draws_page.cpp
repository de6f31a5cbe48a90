#include "experiments/study/executors/draws_page.hpp"

#include "common/decimal.hpp"
#include "common/table_text.hpp"
#include "experiments/study/statistics/markdown.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace evbal {
namespace {

constexpr std::size_t shown_worst = 5;
constexpr std::size_t shown_influences = 10;

std::string spread_table(const DrawnController& drawn) {
  Words head = {"metric"};
  for (const auto& [name, value] : named(Distribution{})) {
    head.push_back(name);
  }
  head.emplace_back("without faults");
  std::string text = header(head, 1);
  for (const auto& metric : drawn.metrics) {
    Words cells = {"`" + metric.name + "`"};
    for (const auto& [name, value] : named(metric.distribution)) {
      cells.push_back(rounded(value));
    }
    cells.push_back(rounded(metric.without));
    text += table_row(cells);
  }
  return text;
}

std::string quantity_text(const DrawnQuantity& quantity, std::size_t draw) {
  const double value = quantity.values[draw];
  if (std::isnan(value)) {
    return "none";
  }
  if (quantity.quantity != "start") {
    return value == std::round(value) ? fixed(value, 0) : rounded(value);
  }
  const int minute = static_cast<int>(value);
  const std::string padding = minute % 60 < 10 ? "0" : "";
  return std::to_string(minute / 60) + ":" + padding + std::to_string(minute % 60);
}

/// The strongest quantities that are no single regions.
std::vector<const DrawnQuantity*> telling(const DrawnController& drawn) {
  constexpr std::size_t most = 6;
  std::vector<const DrawnQuantity*> chosen;
  for (const auto& influence : drawn.influences) {
    const auto quantity = std::find_if(drawn.quantities.begin(), drawn.quantities.end(), [&](const DrawnQuantity& one) {
      return one.fault == influence.fault && one.quantity == influence.quantity;
    });
    if (chosen.size() < most && !influence.quantity.starts_with("in region ")) {
      chosen.push_back(&*quantity);
    }
  }
  return chosen;
}

std::string worst_table(const DrawnController& drawn) {
  std::vector<std::size_t> order(drawn.values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return drawn.largest_is_worst ? drawn.values[a] > drawn.values[b] : drawn.values[a] < drawn.values[b];
  });
  order.resize(std::min(order.size(), shown_worst));
  const std::vector<const DrawnQuantity*> quantities = telling(drawn);
  Words head = {"draw", "`" + drawn.worst_metric + "`"};
  for (const auto* quantity : quantities) {
    head.push_back(quantity->fault + ": " + quantity->quantity);
  }
  std::string text = header(head, 1);
  for (const std::size_t draw : order) {
    Words cells = {std::to_string(draw + 1), rounded(drawn.values[draw])};
    for (const auto* quantity : quantities) {
      cells.push_back(quantity_text(*quantity, draw));
    }
    text += table_row(cells);
  }
  return text;
}

std::string influence_table(const DrawnController& drawn) {
  std::string text = header({"fault", "what of it", "draws", "rank correlation", "95 %", "p, after Holm"}, 2);
  for (std::size_t i = 0; i < std::min(shown_influences, drawn.influences.size()); ++i) {
    const Influence& row = drawn.influences[i];
    text += table_row({row.fault, row.quantity, std::to_string(row.draws), fixed(row.correlation.mean, 2, true),
                       range(row.correlation, 1.0, 2, true), fixed(row.p_adjusted, 4)});
  }
  return text;
}

}  // namespace

std::string draws_markdown(const DrawsResult& result) {
  std::string text = "# Draws of the faults\n\n" + std::to_string(result.controllers.front().draws) +
                     " draws of one schedule on the same day. `runs.csv` has a row for each.\n";
  for (const auto& drawn : result.controllers) {
    text += "\n## How the day turns out under " + drawn.controller + "\n\n" + spread_table(drawn);
    text += "\n## The worst draws under " + drawn.controller + "\n\n" + worst_table(drawn);
    text += "\n## Which fault did it under " + drawn.controller + "\n\n";
    text += "Spearman's rank correlation of `" + drawn.worst_metric +
            "` with what differs between draws: near +1 it grows with it, near -1 it falls, near 0 it has little to do "
            "with it. p is by random orders of the draws, adjusted by Holm for all " +
            std::to_string(drawn.influences.size()) +
            " rows: above 0.05 nothing was shown. All rows are in `influence.csv`.\n\n" + influence_table(drawn);
  }
  return text;
}

std::string influence_csv(const DrawsResult& result) {
  std::string text = "controller,metric,fault,quantity,draws,correlation,low,high,p,p_holm\n";
  for (const auto& drawn : result.controllers) {
    for (const auto& row : drawn.influences) {
      const bool known = is_known(row.correlation);
      text += csv_row({drawn.controller, drawn.worst_metric, row.fault, row.quantity, decimal(row.draws),
                       decimal(row.correlation.mean), known ? decimal(row.correlation.low) : "",
                       known ? decimal(row.correlation.high) : "", decimal(row.p), decimal(row.p_adjusted)});
    }
  }
  return text;
}

}  // namespace evbal
