#pragma once

#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/design/prices.hpp"
#include "experiments/study/design/replications.hpp"
#include "experiments/study/design/sweep.hpp"
#include "experiments/study/design/tuned.hpp"

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

/// The search for each controller's settings on training days (docs/tuning.md): candidates that are spread over the
/// ranges, then others around the best of them, on ever more of the same days.
namespace evbal {

/// A range that is searched by its logarithm, or the values of a list.
struct SearchAxis {
  std::string path;                                  ///< key, with dots between levels
  double from = 0.0;                                 ///< least value that is tried at first
  double to = 0.0;                                   ///< greatest value that is tried at first
  double least = 0.0;                                ///< which the search never goes below
  double most = std::numeric_limits<double>::max();  ///< which it never goes above
  std::vector<YamlValue> choices{};                  ///< in place of the range
};

/// A controller and the settings that are searched.
struct Tunable {
  std::string name;                ///< of the variant
  ChosenController controller;     ///< who plans
  std::vector<Setting> settings;   ///< of all of its candidates
  std::vector<SearchAxis> search;  ///< what is searched, and where
};

/// What is tuned, and on which days.
struct Tuning {
  Replications replications;        ///< training days and seeds
  Prices objective{};               ///< the sum is to be small
  int candidates = 0;               ///< of every variant on the first share of the replications
  std::vector<Tunable> variants{};  ///< all tuned alike
};

/// Reads a tuning. Throws Error{bad_input} with file, line, reason and what would be right, also if a day is not one of
/// the training days of every scenario's city. `quick`: four candidates, one day, one seed.
Tuning read_tuning(const std::filesystem::path& file, bool quick);

/// A candidate with what it has shown so far.
struct Candidate {
  int number = 0;                   ///< from 1
  int round = 1;                    ///< in which it was new
  std::vector<double> places{};     ///< on each axis: 0 is `from`, 1 is `to`, by the logarithm; or within a list
  std::vector<Setting> settings{};  ///< that it tries
  std::vector<double> sums{};       ///< objective on each of its days: the first ones of the contest's replications;
                                    ///< infinite on a day that failed

  /// Mean of `sums`; 0 before any day.
  double objective() const;

  /// Whether it has days, and none of them failed.
  bool has_played() const;
};

/// A part of an axis, in places as those of candidates.
struct Span {
  double low = 0.0;   ///< lower end
  double high = 1.0;  ///< upper end
};

/// A variant in one scenario.
struct Contest {
  std::string scenario;                            ///< its name
  std::size_t variant = 0;                         ///< position in the tuning
  std::vector<PlannedReplication> replications{};  ///< in the order in which they are played
  std::vector<Span> ranges{};                      ///< of each axis, widened where the best lay at an edge
  int round = 1;                                   ///< that is played next
  int points = 0;                                  ///< of Halton's sequence that were taken
  std::vector<Candidate> candidates{};             ///< those that are left first, the best of each round in front
  std::size_t left = 0;                            ///< number of candidates that are left
};

/// The first round's candidates of every scenario and variant.
std::vector<Contest> contests_of(const Tuning& tuning);

/// Whether a round is still to be played.
bool undecided(const std::vector<Contest>& contests);

/// The next round's days, contest by contest and candidate by candidate.
Sweep round_of(const Tuning& tuning, const std::vector<Contest>& contests);

/// Takes note of a round's days, in the order of round_of, of which those that failed have no totals, and keeps and
/// adds the candidates of the next round.
void judge_round(const Tuning& tuning, const std::vector<FinishedDay>& days, std::vector<Contest>& contests);

/// The best of each contest.
Tuned winners(const Tuning& tuning, const std::vector<Contest>& contests);

/// Which of the winner's values lie at an edge of what was searched, as `PATH=VALUE, lower edge`.
std::vector<std::string> edges_of(const Tuning& tuning, const Contest& contest);

/// candidates.csv: a row a candidate, those that came far first.
std::string candidates_csv(const Tuning& tuning, const std::vector<Contest>& contests);

}  // namespace evbal
