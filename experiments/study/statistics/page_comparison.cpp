#include "experiments/study/statistics/page_comparison.hpp"

#include "common/decimal.hpp"
#include "common/table_text.hpp"
#include "experiments/study/statistics/comparison_table.hpp"
#include "experiments/study/statistics/variant_days.hpp"

#include <algorithm>

namespace evbal {
namespace {

/// A row of a section, and the question that it answers.
struct Answer {
  Question question;
  Compared row;

  std::string who() const {
    return "`" + row.variant + "` against `" + question.reference + "`, " + question.metric + ", " +
           markdown_cell(row.scenario) + (row.faults.empty() ? "" : " " + markdown_cell(row.faults));
  }
  Words cells() const {
    const bool single = row.settings.empty() || row.whole;
    return {markdown_cell(row.scenario), markdown_cell(row.faults),
            row.variant + (single ? "" : " " + markdown_cell(row.settings)), question.reference, question.metric};
  }
};

std::vector<Answer> answers_of(const CompareSection& section, const std::vector<FinishedDay>& days) {
  std::vector<Answer> answers;
  for (const auto& metric : section.metrics) {
    for (const auto& reference : section.against) {
      const Question question{.metric = metric, .reference = reference, .at = section.at};
      Words both = section.variants;
      both.push_back(reference);
      for (const Compared& row : compare(days_of(days, both), question)) {
        if (row.whole || !section.at) {
          answers.push_back({question, row});
        }
      }
    }
  }
  return answers;
}

std::string aim_text(double aim, const Answer& answer) {
  const Compared& row = answer.row;
  const bool known = row.days > 0 && row.relative;
  const std::string result = !known                               ? "not known"
                             : 100.0 * row.difference.high <= aim ? "reached, with the whole interval"
                             : 100.0 * row.difference.mean <= aim ? "reached in the mean, not with the whole interval"
                                                                  : "missed";
  return "- Aim " + fixed(aim, 0, true) + " %, " + answer.who() + ": " + result +
         (known ? " (" + difference_text(row) + ", " + interval_text(row) + ")" : "") + ".\n";
}

std::string aims(const CompareSection& section, const std::vector<Answer>& answers) {
  std::string text;
  for (const auto& [metric, aim] : section.aims) {
    for (const auto& answer : answers) {
      text += answer.question.metric == metric ? aim_text(aim, answer) : "";
    }
  }
  return text.empty() ? "" : "\n" + text;
}

/// What is shown of the primary endpoints, in words.
std::string verdict(const std::vector<PrimaryAnswer>& answers) {
  std::string lower;
  std::string higher;
  std::string open;
  for (const auto& answer : answers) {
    const int side = answer.shown();
    std::string& list = side == 0 ? open : side < 0 ? lower : higher;
    list += (list.empty() ? "" : "; ") + Answer{answer.question, answer.row}.who();
  }
  const auto or_none = [](const std::string& list) { return list.empty() ? "none" : list; };
  return "Lower, with p below 0.05 after Holm's adjustment: " + or_none(lower) + ". Higher: " + or_none(higher) +
         ". No difference is shown: " + or_none(open) + ".\n";
}

}  // namespace

std::string compared(const CompareSection& section, const std::vector<FinishedDay>& days) {
  const auto answers = answers_of(section, days);
  Words names = {"scenario", "faults", "variant", "against", "metric"};
  const std::size_t left = names.size();
  const Words numbers = comparison_head({.at = section.at}, "value", "reference");
  names.insert(names.end(), numbers.begin(), numbers.end());
  if (!section.primaries.empty()) {
    names.emplace_back("endpoint");
  }
  std::string text = header(names, left);
  for (const auto& answer : answers) {
    Words cells = answer.cells();
    const Words more = comparison_cells(answer.row, answer.question);
    cells.insert(cells.end(), more.begin(), more.end());
    if (!section.primaries.empty()) {
      const bool primary = std::any_of(section.primaries.begin(), section.primaries.end(), [&](const auto& endpoint) {
        return is_row_of(endpoint, answer.question, answer.row);
      });
      cells.emplace_back(primary ? "primary" : "");
    }
    text += table_row(cells);
  }
  return text + aims(section, answers);
}

std::string primaries(const std::vector<PrimaryAnswer>& answers) {
  const std::string exploratory =
      "exploratory: its interval stands for itself alone, and of twenty such intervals one misses on average.\n";
  if (answers.empty()) {
    return "The file names no primary endpoint. Every row of a comparison is " + exploratory;
  }
  std::string text = header({"section", "scenario", "faults", "variant", "against", "metric", "difference", "95 % by t",
                             "p", "p, Holm", "days"},
                            6);
  for (const auto& answer : answers) {
    Words cells = Answer{answer.question, answer.row}.cells();
    cells.insert(cells.begin(), markdown_cell(answer.section));
    const bool known = answer.row.days > 0;
    for (const std::string& cell :
         {known ? difference_text(answer.row) : "", known ? interval_text(answer.row) : "",
          known ? p_text(answer.row.p) : "", known ? p_text(answer.p_holm) : "", std::to_string(answer.row.days)}) {
      cells.push_back(cell);
    }
    text += table_row(cells);
  }
  return text + "\n" + verdict(answers) +
         "\np is of Student's t test on the days' results, beside it as Holm adjusts it for all rows of this table. "
         "Every "
         "other row of a comparison is " +
         exploratory;
}

}  // namespace evbal
