#include "tools/evbal/compared_csv.hpp"

#include "common/decimal.hpp"
#include "common/table_text.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

std::string number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? decimal(*value) : "";
}

std::vector<std::string> cells_of(const Compared& row, const Question& question,
                                  const std::vector<PrimaryAnswer>& primaries) {
  std::vector<std::string> cells = {row.scenario,
                                    row.faults,
                                    row.variant,
                                    row.settings,
                                    question.metric,
                                    question.reference,
                                    question.at.value_or(""),
                                    row.whole ? "true" : "false"};
  for (const int count : {row.days, row.apart, row.points, row.inside}) {
    cells.push_back(std::to_string(count));
  }
  const auto primary = std::find_if(primaries.begin(), primaries.end(),
                                    [&](const PrimaryAnswer& answer) { return answer.is(question, row); });
  const auto p_holm = primary == primaries.end() ? std::nullopt : std::optional(primary->p_holm);
  std::vector<std::string> numbers = {number(row.from),
                                      number(row.to),
                                      number(row.covered),
                                      number(row.value),
                                      number(row.reference),
                                      number(of_totals(row)),
                                      row.relative ? "true" : "false",
                                      number(row.difference.mean),
                                      number(row.difference.low),
                                      number(row.difference.high),
                                      number(row.p),
                                      number(p_holm),
                                      number(row.way)};
  if (row.days == 0) {
    std::fill(numbers.begin(), numbers.end(), "");
  }
  cells.insert(cells.end(), numbers.begin(), numbers.end());
  return cells;
}

}  // namespace

std::string compared_csv(const std::vector<AnsweredQuestion>& answers, const std::vector<PrimaryAnswer>& primaries) {
  std::string text = csv_row({"scenario", "faults",     "variant", "settings", "metric",    "reference_variant",
                              "at",       "whole",      "days",    "apart",    "points",    "inside",
                              "from",     "to",         "covered", "value",    "reference", "of_totals",
                              "relative", "difference", "low",     "high",     "p",         "p_holm",
                              "way"});
  for (const auto& [question, rows] : answers) {
    for (const Compared& row : rows) {
      text += csv_row(cells_of(row, question, primaries));
    }
  }
  return text;
}

}  // namespace evbal
