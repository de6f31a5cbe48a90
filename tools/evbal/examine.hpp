#pragma once

#include "experiments/study/design/benchmark.hpp"
#include "tools/evbal/playing_options.hpp"
#include "tools/evbal/study_line.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// A study that has been played.
struct Examined {
  StudyLine line;                    ///< its days
  std::vector<StudyResult> results;  ///< what they say
};

/// Tunes the entry on each part's training days if it has something to search, plays the days that have no result in
/// `out` yet, and computes the bounds that are not kept yet. Into `out`, for each PART: PART.tuning.yaml and
/// PART.sweep.yaml, a tuning and a sweep like any other, and the folder PART that they are played into. Throws Error.
Examined examine(const std::filesystem::path& benchmark, const Entry& entry, const std::filesystem::path& out,
                 const PlayingOptions& options);

/// How a line is verified.
struct Verifying {
  std::uint64_t seed = 0;  ///< of the choice of days
  Command coordinator{};   ///< in place of the line's; empty: that
  PlayingOptions options;  ///< how days are played
};

/// Holds a line against what its days say and against a tenth of its days, one at least, and a bound of each part,
/// which are chosen by the seed and played or computed again. `place` names the line in messages. Returns what was
/// done. Throws Error{expectation_failed} if something does not hold, Error{bad_input} if the line is of another
/// benchmark or version.
std::string verify_line(const std::string& text, const std::string& place, const Verifying& verifying);

}  // namespace evbal
