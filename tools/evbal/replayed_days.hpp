#pragma once

#include "common/random.hpp"
#include "experiments/study/design/sweep.hpp"
#include "tools/evbal/playing_options.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// `count` of 0..all-1 at random, each at most once, ascending. `count` is at most `all`.
std::vector<std::size_t> random_choice(std::size_t count, std::size_t all, RandomStream& random);

/// Plays `count` days of a sweep again that are in `file`, chosen by `seed`, or all if it has fewer, and says in a line
/// that they hold. Throws Error{expectation_failed} with the days whose digest is another than that in the file, and
/// Error{bad_input} if the sweep is not played to its end.
std::string replay_days(const Sweep& sweep, const std::filesystem::path& file, std::size_t count, std::uint64_t seed,
                        const PlayingOptions& options);

}  // namespace evbal
