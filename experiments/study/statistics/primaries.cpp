#include "experiments/study/statistics/primaries.hpp"

#include "common/decimal.hpp"
#include "experiments/study/statistics/variant_days.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace evbal {
namespace {

constexpr double shown_below = 0.05;

PrimaryAnswer answered(const std::string& title, const PrimaryEndpoint& primary, const CompareSection& section,
                       const std::vector<FinishedDay>& days) {
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

/// The endpoints of the page's verdict and sections, each once, with what came of it by itself.
class Answers {
 public:
  explicit Answers(const std::vector<FinishedDay>& days) : days_(days) {}

  void add(const std::string& title, const CompareSection& section) {
    for (const PrimaryEndpoint& primary : section.primaries) {
      PrimaryAnswer answer = answered(title, primary, section, days_);
      const bool known = std::any_of(answers_.begin(), answers_.end(), [&](const PrimaryAnswer& other) {
        return other.question.at == section.at && other.endpoint() == primary;
      });
      if (!known) {
        answers_.push_back(std::move(answer));
      }
    }
  }

  std::vector<PrimaryAnswer> adjusted() && {
    std::vector<double> p;
    std::transform(answers_.begin(), answers_.end(), std::back_inserter(p),
                   [](const PrimaryAnswer& answer) { return answer.row.p; });
    const std::vector<double> by_holm = holm(p);
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      answers_[i].p_holm = by_holm[i];
    }
    return std::move(answers_);
  }

 private:
  const std::vector<FinishedDay>& days_;
  std::vector<PrimaryAnswer> answers_{};
};

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

int PrimaryAnswer::shown() const {
  return row.days == 0 || p_holm >= shown_below ? 0 : row.difference.mean < 0.0 ? -1 : 1;
}

PrimaryEndpoint PrimaryAnswer::endpoint() const {
  return {row.scenario, row.faults, row.variant, question.reference, question.metric};
}

bool PrimaryAnswer::is(const Question& asked, const Compared& other) const {
  return question.at == asked.at && is_row_of(endpoint(), asked, other);
}

std::vector<FinishedDay> with_objective(const Page& page, std::vector<FinishedDay> days) {
  for (auto& day : days) {
    day.totals["objective"] = priced(page.objective, day);
  }
  return days;
}

std::vector<PrimaryAnswer> primary_answers(const Page& page, const std::vector<FinishedDay>& days) {
  Answers answers(days);
  for (const VerdictQuestion& asked : page.verdict) {
    for (const CompareSection& fronts : asked.fronts) {
      answers.add(asked.question, fronts);
    }
  }
  for (const PageSection& section : page.sections) {
    for (const auto* table : {&section.compare, &section.fronts}) {
      if (*table) {
        answers.add(section.title, **table);
      }
    }
  }
  return std::move(answers).adjusted();
}

std::string p_text(double p) {
  return p < 0.0001 ? "< 0.0001" : fixed(p, 4);
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
