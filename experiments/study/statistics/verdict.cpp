#include "experiments/study/statistics/verdict.hpp"

#include "common/decimal.hpp"
#include "common/table_text.hpp"
#include "experiments/study/statistics/markdown.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace evbal {
namespace {

constexpr double per_cent = 100.0;

/// The answers to a question.
std::vector<PrimaryAnswer> answers_to(const VerdictQuestion& asked, const std::vector<PrimaryAnswer>& answers) {
  std::vector<PrimaryAnswer> found;
  for (const CompareSection& fronts : asked.fronts) {
    for (const PrimaryEndpoint& primary : fronts.primaries) {
      found.push_back(*std::find_if(answers.begin(), answers.end(), [&](const PrimaryAnswer& answer) {
        return answer.question.at == fronts.at && answer.endpoint() == primary;
      }));
    }
  }
  return found;
}

/// "A, B and C".
std::string enumerated(const Words& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  }
  return text;
}

std::string with_number(double value, int digits, bool sign) {
  std::string text = fixed(value, digits, sign);
  return text.front() == '-' ? "−" + text.substr(1) : text;
}

std::string capitalised(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

/// What the answers to one question have in common, and what each is told by.
class Told {
 public:
  Told(const Page& page, const std::vector<PrimaryAnswer>& answers) : page_(page) {
    for (const PrimaryAnswer& answer : answers) {
      pairs_.insert({answer.row.variant, answer.question.reference});
      variants_.insert(answer.row.variant);
      faults_.insert(answer.row.faults);
      places_.insert({answer.row.scenario, answer.row.faults});
    }
  }

  /// What stands before the label of answers.
  std::string preposition() const { return one_pair() ? "in " : "with "; }

  /// What tells the answer from the others: its place, its variant, or all.
  std::string label_of(const PrimaryAnswer& answer) const {
    const bool by_variant = one_place() && variants_.size() == pairs_.size();
    return one_pair() ? place_of(answer) : by_variant ? words(answer.row.variant) : compared(answer);
  }

  /// What the numbers of all answers have in common; empty if nothing.
  std::string common(const PrimaryAnswer& any) const {
    return one_pair() ? pair_of(any) : one_place() ? "in " + place_of(any) : "";
  }

  /// What an answer's number is told by, beside what is common.
  std::string compared(const PrimaryAnswer& answer) const {
    return one_pair() ? place_of(answer) : pair_of(answer) + (one_place() ? "" : " in " + place_of(answer));
  }

 private:
  bool one_pair() const { return pairs_.size() == 1; }
  bool one_place() const { return places_.size() == 1; }

  std::string pair_of(const PrimaryAnswer& answer) const {
    return words(answer.row.variant) + " against " + words(answer.question.reference);
  }

  std::string place_of(const PrimaryAnswer& answer) const {
    return words(answer.row.scenario) + (faults_.size() > 1 ? ", " + words(answer.row.faults) : "");
  }

  std::string words(const std::string& name) const { return markdown_cell(words_for(page_, name)); }

  const Page& page_;
  std::set<std::pair<std::string, std::string>> pairs_{};
  std::set<std::pair<std::string, std::string>> places_{};
  std::set<std::string> variants_{};
  std::set<std::string> faults_{};
};

/// The answers' labels by what is shown.
struct Sorted {
  std::string preposition;
  Words better{};
  Words worse{};
  Words open{};
  Words unanswered{};

  Sorted(const Told& told, const std::vector<PrimaryAnswer>& answers) : preposition(told.preposition()) {
    for (const PrimaryAnswer& answer : answers) {
      const int side = answer.shown();
      Words& list = answer.row.days == 0 ? unanswered : side < 0 ? better : side > 0 ? worse : open;
      list.push_back(told.label_of(answer));
    }
  }

  /// Yes, no, mixed or not shown.
  std::string conclusion() const {
    const std::string first = !better.empty() && !worse.empty() ? "Mixed"
                              : !better.empty() ? (open.empty() && unanswered.empty() ? "Yes" : "In part")
                              : !worse.empty()  ? "No"
                              : !open.empty()   ? "Not shown"
                                                : "Not answered";
    const int kinds = static_cast<int>(!better.empty()) + static_cast<int>(!worse.empty()) +
                      static_cast<int>(!open.empty()) + static_cast<int>(!unanswered.empty());
    if (kinds == 1) {
      return first + (worse.empty() ? "" : ", it is worse") + ".";
    }
    std::string text;
    for (const auto& [words, labels] : {std::pair("better ", &better), std::pair("worse ", &worse),
                                        std::pair("not shown ", &open), std::pair("not answered ", &unanswered)}) {
      text += labels->empty() ? "" : (text.empty() ? "" : "; ") + (words + preposition + enumerated(*labels));
    }
    return (better.empty() && worse.empty() ? capitalised(text) : first + ": " + text) + ".";
  }
};

std::string asked_words(const Question& question) {
  return question.metric == "idle_km" ? "Kilometres driven empty at equally many lost passengers (fewer is better)"
                                      : "Passengers lost at equal kilometres driven empty (fewer is better)";
}

/// A question's answer. `said` is what the one before told, which is not told again.
std::string paragraph(const Page& page, const VerdictQuestion& asked, const std::vector<PrimaryAnswer>& all,
                      std::string& said) {
  const auto answers = answers_to(asked, all);
  const Told told(page, answers);
  std::string text = "**" + asked.question + " " + Sorted(told, answers).conclusion() + "**";
  Words numbers;
  for (const PrimaryAnswer& answer : answers) {
    if (answer.row.days > 0) {
      numbers.push_back(told.compared(answer) + " " + signed_per_cent(answer.row.difference.mean) + " (" +
                        interval_words(answer.row.difference) + ")");
    }
  }
  if (!numbers.empty()) {
    const std::string what = asked_words(answers.front().question);
    const std::string common = told.common(answers.front());
    const std::string begin = what == said ? common : what + (common.empty() ? "" : ", " + common);
    text += " " + capitalised(begin + (begin.empty() ? "" : ": ") + enumerated(numbers)) + ".";
    said = what;
  }
  return text;
}

/// Who went farthest to the bound under one schedule of faults in one scenario.
struct Farthest {
  std::string scenario;
  std::string faults;
  Compared row{};  ///< of the variant; no way: no bound is known
};

/// The variants that the verdict asks about.
Words variants_asked(const Page& page) {
  std::set<std::string> variants;
  for (const VerdictQuestion& asked : page.verdict) {
    for (const CompareSection& fronts : asked.fronts) {
      variants.insert(fronts.variants.begin(), fronts.variants.end());
    }
  }
  return {variants.begin(), variants.end()};
}

/// Of each scenario and schedule of faults of the verdict, in its order.
std::vector<Farthest> farthest(const Page& page, const PageDays& days, const Question& question) {
  std::vector<Farthest> all;
  for (const VerdictQuestion& asked : page.verdict) {
    for (const CompareSection& fronts : asked.fronts) {
      for (const PrimaryEndpoint& primary : fronts.primaries) {
        if (std::none_of(all.begin(), all.end(), [&](const Farthest& one) {
              return one.scenario == primary.scenario && one.faults == primary.faults;
            })) {
          all.push_back({primary.scenario, primary.faults});
        }
      }
    }
  }
  for (Farthest& here : all) {
    for (const Compared& row : whole_rows(days, variants_asked(page), question, {here.scenario}, {here.faults})) {
      if (row.way && (!here.row.way || *row.way > *here.row.way)) {
        here.row = row;
      }
    }
  }
  return all;
}

/// How far it is from what could be.
std::string distance(const Page& page, const PageDays& days) {
  const std::string& reference = page.verdict.front().fronts.front().primaries.front().against;
  const auto all = farthest(page, days, {.metric = "lost", .reference = reference, .at = "idle_km"});
  const bool one_schedule =
      std::all_of(all.begin(), all.end(), [&](const Farthest& one) { return one.faults == all.front().faults; });
  std::set<std::string> best;
  for (const Farthest& one : all) {
    if (one.row.way) {
      best.insert(one.row.variant);
    }
  }
  Words known;
  Words unknown;
  for (const Farthest& one : all) {
    const std::string place = markdown_cell(words_for(page, one.scenario)) +
                              (one_schedule ? "" : ", " + markdown_cell(words_for(page, one.faults)));
    if (!one.row.way) {
      unknown.push_back(place);
      continue;
    }
    const std::string partly =
        one.row.way_days == one.row.days
            ? ""
            : "the bound is of " + std::to_string(one.row.way_days) + " of " + std::to_string(one.row.days) + " days";
    const std::string who = best.size() == 1 ? "" : markdown_cell(words_for(page, one.row.variant));
    const std::string more = who + (who.empty() || partly.empty() ? "" : "; ") + partly;
    known.push_back(with_number(per_cent * *one.row.way, 0, false) + " % " + (known.empty() ? "of the way " : "") +
                    "in " + place + (more.empty() ? "" : " (" + more + ")"));
  }
  const std::string question = "**How far is the best from what could be?";
  if (known.empty()) {
    return question + "** No bound was computed, so that is not known.";
  }
  return question + " " + enumerated(known) + ".** All days added up, " +
         (best.size() == 1 ? markdown_cell(words_for(page, *best.begin())) : "the best of the above") +
         " saves that share of what " + markdown_cell(words_for(page, reference)) +
         " loses beyond the bound, below which no planner can be; the differences above count a quiet day as much as a "
         "busy one." +
         (unknown.empty() ? "" : " No bound was computed for " + enumerated(unknown) + ".");
}

/// What the words of the verdict mean.
std::string reading(const std::vector<PrimaryAnswer>& answers) {
  int least = 0;
  int most = 0;
  for (const PrimaryAnswer& answer : answers) {
    if (answer.row.days > 0) {
      least = least == 0 ? answer.row.days : std::min(least, answer.row.days);
      most = std::max(most, answer.row.days);
    }
  }
  const std::string days = std::to_string(most) + (most == 1 ? " day" : " days");
  return "Differences are means over the kilometres that both methods can drive, then over " +
         (least == most ? days : std::to_string(least) + " to " + days) +
         "; in brackets their 95 % intervals. Better or worse is said where p is below 0.05 after Holm's adjustment "
         "for all " +
         std::to_string(answers.size()) + " primary endpoints.";
}

}  // namespace

std::string signed_per_cent(double share) {
  return with_number(per_cent * share, 1, true) + " %";
}

std::string interval_words(const Interval& interval) {
  return is_known(interval) ? with_number(per_cent * interval.low, 1, true) + " to " +
                                  with_number(per_cent * interval.high, 1, true) + " %"
                            : "interval not known";
}

std::string verdict_text(const Page& page, const PageDays& days, const std::vector<PrimaryAnswer>& answers) {
  if (page.verdict.empty()) {
    return "";
  }
  std::string text = page.introduction + (page.introduction.empty() ? "" : "\n\n");
  std::string said;
  for (const VerdictQuestion& asked : page.verdict) {
    text += paragraph(page, asked, answers, said) + "\n\n";
  }
  return text + distance(page, days) + "\n\n" + reading(answers) + "\n";
}

}  // namespace evbal
