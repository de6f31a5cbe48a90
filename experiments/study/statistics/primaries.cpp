#include "experiments/study/statistics/primaries.hpp"

#include "experiments/study/statistics/variant_days.hpp"

#include <algorithm>
#include <cstddef>

namespace evbal {
namespace {

PrimaryAnswer answered(const std::string& title, const CompareSection& section, const std::vector<FinishedDay>& days) {
  const PrimaryEndpoint& primary = *section.primary;
  PrimaryAnswer answer{.section = title,
                       .question = {.metric = primary.metric, .reference = primary.against, .at = section.at},
                       .row = {.scenario = primary.scenario, .faults = primary.faults, .variant = primary.variant}};
  const auto some = days_of(days, {primary.variant, primary.against});
  const bool both =
      std::any_of(some.begin(), some.end(), [&](const auto& day) { return day.variant == primary.against; });
  const auto rows = both ? compare(some, answer.question) : std::vector<Compared>();
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return is_row_of(primary, answer.question, row); });
  if (found != rows.end()) {
    answer.row = *found;
  }
  return answer;
}

template <class Value>
std::vector<std::string> distinct(const std::vector<FinishedDay>& days, const Value& value) {
  std::vector<std::string> names;
  for (const auto& day : days) {
    if (std::find(names.begin(), names.end(), value(day)) == names.end()) {
      names.push_back(value(day));
    }
  }
  return names;
}

}  // namespace

bool is_row_of(const PrimaryEndpoint& primary, const Question& question, const Compared& row) {
  return row.whole && row.scenario == primary.scenario && row.faults == primary.faults &&
         row.variant == primary.variant && question.reference == primary.against && question.metric == primary.metric;
}

bool PrimaryAnswer::is(const Question& asked, const Compared& other) const {
  return question.at == asked.at &&
         is_row_of({row.scenario, row.faults, row.variant, question.reference, question.metric}, asked, other);
}

std::vector<FinishedDay> with_objective(const Page& page, std::vector<FinishedDay> days) {
  for (auto& day : days) {
    day.totals["objective"] = priced(page.objective, day);
  }
  return days;
}

std::vector<PrimaryAnswer> primary_answers(const Page& page, const std::vector<FinishedDay>& days) {
  std::vector<PrimaryAnswer> answers;
  std::vector<double> p;
  for (const PageSection& section : page.sections) {
    for (const auto* table : {&section.compare, &section.fronts}) {
      if (*table && (*table)->primary) {
        answers.push_back(answered(section.title, **table, days));
        p.push_back(answers.back().row.p);
      }
    }
  }
  const std::vector<double> adjusted = holm(p);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    answers[i].p_holm = adjusted[i];
  }
  return answers;
}

Page page_of(const std::string& text, const std::vector<FinishedDay>& days) {
  YamlMap map(YamlValue::parse(text, "sweep.sqlite"));
  const auto page = map.find("page");
  return page ? read_page(*page, {distinct(days, [](const auto& day) { return day.variant; }),
                                  distinct(days, [](const auto& day) { return day.scenario; }),
                                  distinct(days, [](const auto& day) { return day.faults; })})
              : Page{};
}

}  // namespace evbal
