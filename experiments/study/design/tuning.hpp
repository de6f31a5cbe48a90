#pragma once

#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/design/prices.hpp"
#include "experiments/study/design/replications.hpp"
#include "experiments/study/design/sweep.hpp"
#include "experiments/study/design/tuned.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// The search for each controller's settings on training days (docs/tuning.md): the same number of candidates, spread
/// evenly over its ranges, and successive halving on the same days for each.
namespace evbal {

/// A range that is searched by its logarithm, or the values of a list.
struct SearchAxis {
  std::string path;                  ///< key, with dots between levels
  double from = 0.0;                 ///< least value
  double to = 0.0;                   ///< greatest value
  std::vector<YamlValue> choices{};  ///< in place of the range
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
  int candidates = 0;               ///< of every variant
  std::vector<Tunable> variants{};  ///< all tuned alike
};

/// Reads a tuning. Throws Error{bad_input} with file, line, reason and what would be right, also if a day is not one of
/// the training days of every scenario's city. `quick`: four candidates, one day, one seed.
Tuning read_tuning(const std::filesystem::path& file, bool quick);

/// A candidate with what it has shown so far.
struct Candidate {
  int number = 0;                   ///< from 1
  std::vector<Setting> settings{};  ///< that it tries
  double objective = 0.0;           ///< mean of its last round's days
  int days = 0;                     ///< that were played in its last round
};

/// A variant in one scenario.
struct Contest {
  std::string scenario;                 ///< its name
  std::size_t variant = 0;              ///< position in the tuning
  std::vector<Candidate> candidates{};  ///< those that are left first, the best of each round in front
  std::size_t left = 0;                 ///< number of candidates that are left
};

/// All candidates of every scenario and variant.
std::vector<Contest> contests_of(const Tuning& tuning);

/// Whether a round is still to be played.
bool undecided(const std::vector<Contest>& contests);

/// The next round's days, contest by contest and candidate by candidate: a share of the replications that doubles as
/// the candidates that are left halve, all of them in the round of the last two.
Sweep round_of(const Tuning& tuning, const std::vector<Contest>& contests);

/// Takes note of a round's days, in the order of round_of, and keeps the better half of each contest.
void judge_round(const Tuning& tuning, const std::vector<FinishedDay>& days, std::vector<Contest>& contests);

/// The best of each contest.
Tuned winners(const Tuning& tuning, const std::vector<Contest>& contests);

/// candidates.csv: a row a candidate, those that came far first.
std::string candidates_csv(const Tuning& tuning, const std::vector<Contest>& contests);

}  // namespace evbal
