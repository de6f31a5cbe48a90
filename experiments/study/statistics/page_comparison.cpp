#include "experiments/study/statistics/page_comparison.hpp"

#include "common/decimal.hpp"
#include "common/table_text.hpp"
#include "experiments/study/statistics/comparison.hpp"
#include "experiments/study/statistics/front_comparison.hpp"
#include "experiments/study/statistics/markdown.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace evbal {
namespace {

constexpr double shown_below = 0.05;

/// The days of `variants`, in the order of the sweep.
std::vector<FinishedDay> days_of(const std::vector<FinishedDay>& days, const Words& variants) {
  std::vector<FinishedDay> some;
  std::copy_if(days.begin(), days.end(), std::back_inserter(some),
               [&](const FinishedDay& day) { return contains(variants, day.variant); });
  return some;
}

/// A comparison of a section: a variant, all its settings together, against a reference.
struct Answer {
  Question question;
  Compared row;

  std::string who() const {
    return "`" + row.variant + "` against `" + question.reference + "`, " + question.metric + ", " +
           markdown_cell(row.scenario) + (row.faults.empty() ? "" : " " + markdown_cell(row.faults));
  }
};

std::vector<Answer> answers_of(const CompareSection& section, const std::vector<FinishedDay>& days) {
  std::vector<Answer> answers;
  for (const auto& metric : section.metrics) {
    for (const auto& reference : section.against) {
      const Question question{.metric = metric, .reference = reference, .at = section.at};
      Words both = section.variants;
      both.push_back(reference);
      const auto rows = compare(days_of(days, both), question);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto same = [&](const Compared& other) {
          return std::tie(other.scenario, other.faults, other.variant) ==
                 std::tie(rows[i].scenario, rows[i].faults, rows[i].variant);
        };
        if (i + 1 == rows.size() || !same(rows[i + 1])) {
          answers.push_back({question, rows[i]});
        }
      }
    }
  }
  std::vector<Compared> family;
  family.reserve(answers.size());
  for (const auto& answer : answers) {
    family.push_back(answer.row);
  }
  adjust(family);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    answers[i].row = family[i];
  }
  return answers;
}

Words difference_cells(const Compared& row) {
  if (row.pairs == 0) {
    return {"", "", "", "", "", "", ""};
  }
  const Interval& shown = row.relative ? row.by_t : row.difference;
  const double factor = row.relative ? 100.0 : 1.0;
  return {rounded(row.value),
          rounded(row.reference),
          fixed(factor * shown.mean, 1, true) + (row.relative ? " %" : ""),
          range(shown, factor, 1, true),
          row.relative ? range(row.by_bootstrap, factor, 1, true) : "",
          fixed(row.p, 4),
          fixed(row.p_holm, 4)};
}

/// What the table shows, in words, by one rule for all.
std::string verdict(const std::vector<Answer>& answers) {
  std::string lower;
  std::string higher;
  int open = 0;
  for (const auto& answer : answers) {
    if (answer.row.pairs > 0 && answer.row.p_holm < shown_below) {
      const Interval& shown = answer.row.relative ? answer.row.by_t : answer.row.difference;
      std::string& list = shown.mean < 0.0 ? lower : higher;
      list += (list.empty() ? "" : "; ") + answer.who();
    } else {
      ++open;
    }
  }
  return "p below 0.05 after Holm's adjustment, rows in all: " + std::to_string(answers.size()) +
         ". Lower: " + (lower.empty() ? "none" : lower) + ". Higher: " + (higher.empty() ? "none" : higher) +
         ". Rows in which no difference is shown: " + std::to_string(open) + ".\n";
}

std::string aims(const CompareSection& section, const std::vector<Answer>& answers) {
  std::string text;
  for (const auto& [metric, aim] : section.aims) {
    for (const auto& answer : answers) {
      if (answer.question.metric == metric) {
        const Compared& row = answer.row;
        const bool known = row.pairs > 0 && row.relative;
        const bool mean = known && 100.0 * row.by_t.mean <= aim;
        text += "- Aim " + fixed(aim, 0, true) + " %, " + answer.who() + ": " +
                (!known                         ? "not known"
                 : 100.0 * row.by_t.high <= aim ? "reached, with the whole interval"
                 : mean                         ? "reached in the mean, not with the whole interval"
                                                : "missed") +
                (known ? " (" + fixed(100.0 * row.by_t.mean, 1, true) + " %, " + range(row.by_t, 100.0, 1, true) + ")"
                       : "") +
                ".\n";
      }
    }
  }
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

std::string compared(const CompareSection& section, const std::vector<FinishedDay>& days) {
  const auto answers = answers_of(section, days);
  Words names = {"scenario", "faults", "variant", "against", "metric"};
  const std::size_t left = names.size();
  for (const char* name :
       {"value", "reference", "difference", "95 % by t", "by bootstrap", "p", "p, Holm", "pairs", "outside"}) {
    names.emplace_back(name);
  }
  if (section.at) {
    names.insert(names.begin() + static_cast<std::ptrdiff_t>(left), *section.at);
  }
  std::string text = header(names, left);
  for (const auto& [question, row] : answers) {
    Words cells = {markdown_cell(row.scenario), markdown_cell(row.faults), row.variant, question.reference,
                   question.metric};
    if (section.at) {
      cells.push_back(row.pairs > 0 ? rounded(row.at) : "");
    }
    const Words more = difference_cells(row);
    cells.insert(cells.end(), more.begin(), more.end());
    cells.push_back(std::to_string(row.pairs));
    cells.push_back(std::to_string(row.outside));
    text += table_row(cells);
  }
  return text + "\n" + verdict(answers) + aims(section, answers);
}

std::string compared(const FrontsSection& section, const std::vector<FinishedDay>& days) {
  std::string text = header({"scenario", "faults", "variant", "against", "metric", "value", "reference", "of totals",
                             "difference", "95 % by t", "p", "days", "apart", "covered"},
                            5);
  const auto per_cent = [](double share) { return fixed(100.0 * share, 1, true) + " %"; };
  for (const auto& metric : section.metrics) {
    for (const auto& reference : section.against) {
      Words both = section.variants;
      both.push_back(reference);
      for (const auto& row : compare_fronts(days_of(days, both), {metric, reference, section.at})) {
        Words cells = {markdown_cell(row.scenario), markdown_cell(row.faults), row.variant, reference, metric};
        const Words known = row.days == 0 ? Words(6)
                                          : Words{rounded(row.value),
                                                  rounded(row.reference),
                                                  row.reference > 0.0 ? per_cent(row.value / row.reference - 1.0) : "",
                                                  per_cent(row.ratio.mean),
                                                  range(row.ratio, 100.0, 1, true),
                                                  fixed(row.p, 4)};
        cells.insert(cells.end(), known.begin(), known.end());
        for (const int count : {row.days, row.apart}) {
          cells.push_back(std::to_string(count));
        }
        cells.push_back(fixed(100.0 * row.covered, 0) + " %");
        text += table_row(cells);
      }
    }
  }
  return text;
}

}  // namespace evbal
