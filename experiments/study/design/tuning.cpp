#include "experiments/study/design/tuning.hpp"

#include "common/contract.hpp"
#include "common/decimal.hpp"
#include "common/error.hpp"
#include "common/table_text.hpp"
#include "experiments/study/design/study_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>

namespace evbal {
namespace {

constexpr std::array primes = {2, 3, 5, 7, 11, 13};
constexpr int last_round = 4;
constexpr double narrowing = 0.7;    // of the span of new candidates, from round to round
constexpr double edge_share = 0.05;  // of a range: what is this near to its end lies at the edge

/// The index's digits in a base, mirrored at the point: a coordinate of Halton's sequence, within (0, 1).
double radical_inverse(int index, int base) {
  double value = 0.0;
  for (double unit = 1.0 / base; index > 0; index /= base, unit /= base) {
    value += index % base * unit;
  }
  return value;
}

YamlValue value_at(const SearchAxis& axis, double place, const std::string& file) {
  if (!axis.choices.empty()) {
    return axis.choices[static_cast<std::size_t>(place * static_cast<double>(axis.choices.size()))];
  }
  return rounded_setting(std::clamp(axis.from * std::pow(axis.to / axis.from, place), axis.least, axis.most), file);
}

double place_of(const SearchAxis& axis, double value) {
  return std::log(value / axis.from) / std::log(axis.to / axis.from);
}

/// Replications of one scenario so that the first ones differ in day and, in turn, in faults.
std::vector<PlannedReplication> in_turn(const std::vector<PlannedReplication>& all) {
  std::set<std::string> days;
  std::set<std::string> faults;
  for (const auto& replication : all) {
    days.insert(replication.day);
    faults.insert(replication.faults);
  }
  const std::size_t seeds = all.size() / days.size() / faults.size();
  std::vector<PlannedReplication> ordered;
  for (std::size_t pass = 0; pass < faults.size(); ++pass) {
    for (std::size_t seed = 0; seed < seeds; ++seed) {
      for (std::size_t day = 0; day < days.size(); ++day) {
        const std::size_t schedule = (day + seed + pass) % faults.size();
        ordered.push_back(all[(schedule * days.size() + day) * seeds + seed]);
      }
    }
  }
  return ordered;
}

/// How many candidates stay, and how many are new, when a round adds some.
std::size_t quarter_of(const Tuning& tuning) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(tuning.candidates) / 4);
}

/// How many of the replications each candidate of the next round plays.
std::size_t replications_for(const Tuning& tuning, const Contest& contest) {
  const std::size_t all = contest.replications.size();
  const auto candidates = static_cast<std::size_t>(tuning.candidates);
  const std::size_t first = std::clamp<std::size_t>((2 * all + candidates - 1) / candidates, 1, all);
  return contest.round < 3 ? first : contest.round < last_round ? std::min(2 * first, all) : all;
}

/// A share of an axis as a place. Of a list, half of the shares are the best's value once there is a best.
double place_at(const SearchAxis& axis, const Span& span, double share, const std::optional<double>& best) {
  if (axis.choices.empty()) {
    return span.low + (span.high - span.low) * share;
  }
  return !best ? share : share < 0.5 ? *best : 2.0 * share - 1.0;
}

/// Adds new candidates to those that are left, spread over `spans`; a point that was tried before is left out.
void add_candidates(const Tuning& tuning, const std::vector<Span>& spans, std::size_t count, Contest& contest) {
  const Tunable& variant = tuning.variants[contest.variant];
  const std::vector<double> best = contest.candidates.empty() ? std::vector<double>{} : contest.candidates[0].places;
  for (std::size_t added = 0; added < count; ++added) {
    Candidate candidate{.number = ++contest.points, .round = contest.round, .settings = variant.settings};
    std::vector<std::string> values;
    for (std::size_t i = 0; i < variant.search.size(); ++i) {
      const SearchAxis& axis = variant.search[i];
      const double share = radical_inverse(contest.points, primes.at(i));
      candidate.places.push_back(place_at(axis, spans[i], share, best.empty() ? std::nullopt : std::optional(best[i])));
      put(candidate.settings, {axis.path, value_at(axis, candidate.places.back(), variant.name)});
    }
    const bool tried = std::any_of(contest.candidates.begin(), contest.candidates.end(), [&](const Candidate& other) {
      return shown_settings(other.settings) == shown_settings(candidate.settings);
    });
    if (!tried) {
      contest.candidates.insert(contest.candidates.begin() + static_cast<std::ptrdiff_t>(contest.left++), candidate);
    }
  }
}

/// Whether the scenario takes this value beside the best candidate's others.
bool is_accepted(const Tuning& tuning, const Contest& contest, const Setting& setting) {
  const Tunable& variant = tuning.variants[contest.variant];
  std::vector<Setting> settings = contest.candidates.front().settings;
  put(settings, setting);
  try {
    scenario_of(day_of(contest.replications.front(), variant.name, variant.controller, settings));
    return true;
  } catch (const Error& error) {
    if (error.status() != ExitStatus::bad_input) {
      throw;
    }
    return false;
  }
}

/// The mean place of the first `count` candidates.
double middle(const Contest& contest, std::size_t count, std::size_t axis) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += contest.candidates[i].places[axis];
  }
  return sum / static_cast<double>(count);
}

/// Where the next candidates are spread on an axis, of which the range is widened if the best lie at its edge.
Span next_span(const Tuning& tuning, std::size_t i, Contest& contest) {
  const SearchAxis& axis = tuning.variants[contest.variant].search[i];
  Span& range = contest.ranges[i];
  const double best = contest.candidates.front().places[i];
  const double of_good = middle(contest, std::min(quarter_of(tuning), contest.left), i);
  const double of_all = middle(contest, contest.left, i);
  const double centre = std::clamp(of_good + (of_good - of_all), range.low, range.high);
  const double reach = 0.5 * std::pow(narrowing, contest.round);
  Span span{centre - reach, centre + reach};
  const double margin = edge_share * (range.high - range.low);
  const auto accepted = [&](double place) {
    return is_accepted(tuning, contest, {axis.path, value_at(axis, place, axis.path)});
  };
  if (std::min(best, centre) < range.low + margin) {
    const double end = axis.least > 0.0 ? std::max(span.low, place_of(axis, axis.least)) : span.low;
    range.low = end < range.low && accepted(end) ? end : range.low;
  }
  if (std::max(best, centre) > range.high - margin) {
    const double end = std::min(span.high, place_of(axis, axis.most));
    range.high = end > range.high && accepted(end) ? end : range.high;
  }
  return {std::max(span.low, range.low), std::min(span.high, range.high)};
}

/// Chooses who plays the next round: all and a quarter more around the best, then the best quarter and as many again
/// around them, then the best two.
void go_on(const Tuning& tuning, Contest& contest) {
  const int judged = contest.round;
  const std::size_t quarter = quarter_of(tuning);
  std::vector<Span> spans;
  if (judged < 3) {
    for (std::size_t i = 0; i < contest.ranges.size(); ++i) {
      spans.push_back(tuning.variants[contest.variant].search[i].choices.empty() ? next_span(tuning, i, contest)
                                                                                 : Span{});
    }
  }
  const std::size_t most = judged == 1 ? contest.left : judged == 2 ? quarter : judged == 3 ? 2 : 1;
  contest.left = std::min(contest.left, most);
  ++contest.round;
  if (judged < 3) {
    add_candidates(tuning, spans, quarter, contest);
  }
}

}  // namespace

double Candidate::objective() const {
  return std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(std::max<std::size_t>(1, sums.size()));
}

bool Candidate::has_played() const {
  return !sums.empty() && std::isfinite(objective());
}

std::vector<Contest> contests_of(const Tuning& tuning) {
  std::vector<Contest> contests;
  for (const auto& scenario : tuning.replications.scenarios()) {
    const std::vector<PlannedReplication> replications = in_turn(tuning.replications.of(scenario));
    for (std::size_t v = 0; v < tuning.variants.size(); ++v) {
      Contest contest{.scenario = scenario, .variant = v, .replications = replications};
      contest.ranges.resize(tuning.variants[v].search.size());
      add_candidates(tuning, contest.ranges, static_cast<std::size_t>(tuning.candidates) - quarter_of(tuning), contest);
      contests.push_back(std::move(contest));
    }
  }
  return contests;
}

bool undecided(const std::vector<Contest>& contests) {
  return contests.front().round <= last_round;
}

Sweep round_of(const Tuning& tuning, const std::vector<Contest>& contests) {
  Sweep round;
  for (const auto& contest : contests) {
    const Tunable& variant = tuning.variants[contest.variant];
    const std::size_t count = replications_for(tuning, contest);
    for (std::size_t i = 0; i < contest.left; ++i) {
      const Candidate& candidate = contest.candidates[i];
      note_paths(candidate.settings, round.settings);
      for (std::size_t j = 0; j < count; ++j) {
        round.days.push_back(day_of(contest.replications[j], variant.name, variant.controller, candidate.settings));
      }
    }
  }
  return round;
}

void judge_round(const Tuning& tuning, const std::vector<FinishedDay>& days, std::vector<Contest>& contests) {
  auto day = days.begin();
  for (auto& contest : contests) {
    const std::size_t count = replications_for(tuning, contest);
    for (std::size_t i = 0; i < contest.left; ++i) {
      contest.candidates[i].sums.clear();
      for (std::size_t j = 0; j < count; ++j) {
        EVBAL_EXPECT(day != days.end(), "every day of the round");
        contest.candidates[i].sums.push_back(day->totals.empty() ? std::numeric_limits<double>::infinity()
                                                                 : priced(tuning.objective, *day));
        ++day;
      }
    }
    std::stable_sort(contest.candidates.begin(), contest.candidates.begin() + static_cast<std::ptrdiff_t>(contest.left),
                     [](const Candidate& a, const Candidate& b) { return a.objective() < b.objective(); });
    const auto played = std::count_if(contest.candidates.begin(),
                                      contest.candidates.begin() + static_cast<std::ptrdiff_t>(contest.left),
                                      [](const Candidate& candidate) { return candidate.has_played(); });
    contest.left = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, played));
    go_on(tuning, contest);
  }
  EVBAL_EXPECT(day == days.end(), "no day but the round's");
}

Tuned winners(const Tuning& tuning, const std::vector<Contest>& contests) {
  Tuned tuned;
  for (const auto& contest : contests) {
    const Tunable& variant = tuning.variants[contest.variant];
    tuned[{contest.scenario, variant.name}] = {variant.controller, contest.candidates.front().settings, {}};
  }
  return tuned;
}

std::vector<std::string> edges_of(const Tuning& tuning, const Contest& contest) {
  const Tunable& variant = tuning.variants[contest.variant];
  const Candidate& best = contest.candidates.front();
  std::vector<std::string> edges;
  for (std::size_t i = 0; i < variant.search.size(); ++i) {
    const SearchAxis& axis = variant.search[i];
    const Span& range = contest.ranges[i];
    const double margin = edge_share * (range.high - range.low);
    const bool is_low = best.places[i] < range.low + margin;
    if (axis.choices.empty() && (is_low || best.places[i] > range.high - margin)) {
      edges.push_back(axis.path + "=" + shown(value_at(axis, best.places[i], variant.name)) +
                      (is_low ? ", lower edge" : ", upper edge"));
    }
  }
  return edges;
}

std::string candidates_csv(const Tuning& tuning, const std::vector<Contest>& contests) {
  std::string csv = "scenario,variant,candidate,round,days,failed,objective,settings\n";
  for (const auto& contest : contests) {
    for (const auto& candidate : contest.candidates) {
      csv +=
          csv_row({contest.scenario, tuning.variants[contest.variant].name, decimal(candidate.number),
                   decimal(candidate.round), decimal(candidate.sums.size()),
                   decimal(std::count_if(candidate.sums.begin(), candidate.sums.end(),
                                         [](double sum) { return std::isinf(sum); })),
                   candidate.has_played() ? decimal(candidate.objective()) : "", shown_settings(candidate.settings)});
    }
  }
  return csv;
}

}  // namespace evbal
