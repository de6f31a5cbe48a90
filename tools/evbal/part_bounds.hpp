#pragma once

#include "experiments/study/design/benchmark.hpp"
#include "experiments/study/design/sweep.hpp"
#include "tools/evbal/study_line.hpp"

#include <filesystem>
#include <vector>

namespace evbal {

/// The file of a benchmark that a command line names: a path, or the name of one that is shipped, such as
/// benchmark-toy.yaml. Throws Error{bad_input}.
std::filesystem::path find_benchmark(const std::filesystem::path& given);

/// The bound of a day of the part, at the part's prices alone, whatever else is kept.
StudiedBound bound_of(const BenchmarkPart& part, const SweptDay& day);

/// The bounds of a part's days without faults, of the seeds that are to have one. Says on stderr which one is computed,
/// unless `quiet`.
std::vector<StudiedBound> bounds_of(const BenchmarkPart& part, const Sweep& sweep, bool quiet);

}  // namespace evbal
