#include "experiments/study/statistics/comparison_table.hpp"

#include "common/decimal.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

constexpr double per_cent = 100.0;

int digits_of(const Compared& row) {
  const Interval& shown = row.difference;
  return row.relative       ? 1
         : !is_known(shown) ? digits_for(std::abs(shown.mean))
                            : digits_for(std::max(std::abs(shown.low), std::abs(shown.high)));
}

std::string costs(const Compared& row) {
  return row.from == row.to ? rounded(row.from) : rounded(row.from) + " .. " + rounded(row.to);
}

std::string totals(const Compared& row) {
  const auto ratio = of_totals(row);
  return ratio ? fixed(per_cent * *ratio, 1, true) + " %" : "";
}

}  // namespace

std::string difference_text(const Compared& row) {
  return row.relative ? fixed(per_cent * row.difference.mean, 1, true) + " %"
                      : fixed(row.difference.mean, digits_of(row), true);
}

std::string interval_text(const Compared& row) {
  return range(row.difference, row.relative ? per_cent : 1.0, digits_of(row), true);
}

Words comparison_head(const Question& question, const std::string& value, const std::string& reference) {
  Words head;
  if (question.at) {
    head.push_back(*question.at);
  }
  head.insert(head.end(), {value, reference, "of totals", "difference", "95 % by t", "days"});
  if (question.at) {
    head.insert(head.end(), {"apart", "inside", "covered"});
  }
  if (question.bound) {
    head.emplace_back("of the way");
  }
  return head;
}

Words comparison_cells(const Compared& row, const Question& question) {
  const bool known = row.days > 0;
  Words cells;
  if (question.at) {
    cells.push_back(known ? costs(row) : "");
  }
  const Words numbers =
      known ? Words{rounded(row.value), rounded(row.reference), totals(row), difference_text(row), interval_text(row)}
            : Words(5);
  cells.insert(cells.end(), numbers.begin(), numbers.end());
  cells.push_back(std::to_string(row.days));
  if (question.at) {
    cells.push_back(std::to_string(row.apart));
    cells.push_back(std::to_string(row.inside) + " of " + std::to_string(row.points));
    cells.push_back(row.from < row.to ? fixed(per_cent * row.covered, 0) + " %" : "");
  }
  if (question.bound) {
    cells.push_back(row.way ? fixed(per_cent * *row.way, 0) + " %" : "");
  }
  return cells;
}

}  // namespace evbal
