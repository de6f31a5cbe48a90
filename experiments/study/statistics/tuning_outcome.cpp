#include "experiments/study/statistics/tuning_outcome.hpp"

#include "common/decimal.hpp"
#include "experiments/study/statistics/intervals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace evbal {
namespace {

/// By how much `best` is better than `other`, if there is one, on the first replications that both played.
TunedGain gain_over(const Candidate* other, const Candidate& best, const Contest& contest) {
  if (other == nullptr) {
    return {};
  }
  const std::size_t both = std::min(other->sums.size(), best.sums.size());
  std::vector<DayValue> gains;
  for (std::size_t i = 0; i < both; ++i) {
    gains.push_back({contest.replications[i].day, other->sums[i] - best.sums[i]});
  }
  const Interval interval = t_interval(gains);
  return {static_cast<int>(both), interval.mean, interval.low, interval.high};
}

/// The best after the first round, in which each of its candidates played as much as the one that played least; no one
/// if days of all of them failed.
const Candidate* best_of_first_round(const Contest& contest) {
  std::vector<const Candidate*> first;
  for (const auto& candidate : contest.candidates) {
    if (candidate.round == 1 && candidate.has_played()) {
      first.push_back(&candidate);
    }
  }
  if (first.empty()) {
    return nullptr;
  }
  const auto days = (*std::min_element(first.begin(), first.end(), [](const auto* a, const auto* b) {
                      return a->sums.size() < b->sums.size();
                    }))->sums.size();
  const auto sum = [&](const Candidate& candidate) {
    return std::accumulate(candidate.sums.begin(), candidate.sums.begin() + static_cast<std::ptrdiff_t>(days), 0.0);
  };
  return *std::min_element(first.begin(), first.end(), [&](const auto* a, const auto* b) { return sum(*a) < sum(*b); });
}

TuningOutcome outcome_of(const Tuning& tuning, const Contest& contest) {
  const Candidate& best = contest.candidates.front();
  TuningOutcome outcome{.tried = static_cast<int>(contest.candidates.size()),
                        .objective = best.objective(),
                        .over_first_round = gain_over(best_of_first_round(contest), best, contest),
                        .edges = edges_of(tuning, contest)};
  for (const auto& candidate : contest.candidates) {
    outcome.days += static_cast<int>(candidate.sums.size());
  }
  const auto second = std::find_if(contest.candidates.begin() + 1, contest.candidates.end(),
                                   [](const Candidate& other) { return other.has_played(); });
  outcome.over_second = gain_over(second == contest.candidates.end() ? nullptr : &*second, best, contest);
  return outcome;
}

std::string gain_text(const TunedGain& gain) {
  if (gain.replications == 0) {
    return "none";
  }
  const bool known = std::isfinite(gain.low) && std::isfinite(gain.high);
  return fixed(gain.mean, 1, true) +
         (known ? " (" + fixed(gain.low, 1, true) + " .. " + fixed(gain.high, 1, true) + ")" : " (not known)");
}

std::string edges_text(const std::vector<std::string>& edges) {
  std::string text;
  for (const auto& edge : edges) {
    text += (text.empty() ? "" : "; ") + edge;
  }
  return text.empty() ? "none" : text;
}

}  // namespace

Tuned judged_winners(const Tuning& tuning, const std::vector<Contest>& contests) {
  Tuned tuned = winners(tuning, contests);
  for (const auto& contest : contests) {
    tuned.at({contest.scenario, tuning.variants[contest.variant].name}).outcome = outcome_of(tuning, contest);
  }
  return tuned;
}

std::vector<std::vector<std::string>> tuned_rows(const Tuned& tuned) {
  std::vector<std::vector<std::string>> rows = {{"scenario", "variant", "tried", "days", "objective",
                                                 "ahead of second (95 %)", "regret at most", "ahead of first round",
                                                 "at an edge"}};
  for (const auto& [key, variant] : tuned) {
    if (const auto& outcome = variant.outcome) {
      rows.push_back({key.first, key.second, std::to_string(outcome->tried), std::to_string(outcome->days),
                      fixed(outcome->objective, 1), gain_text(outcome->over_second),
                      std::isfinite(outcome->regret()) ? fixed(outcome->regret(), 1) : "not known",
                      gain_text(outcome->over_first_round), edges_text(outcome->edges)});
    }
  }
  return rows;
}

}  // namespace evbal
