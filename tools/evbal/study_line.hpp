#pragma once

#include "common/command.hpp"
#include "experiments/bound/bound_front.hpp"
#include "experiments/study/design/sweep.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// The line that `evbal study` writes (docs/leaderboard.md): {"content": {...}, "digest": fingerprint of the content,
/// "unsigned": what does not repeat}.
namespace evbal {

/// What a day of a part's sweep came to.
struct StudiedDay {
  double idle_km = 0.0;  ///< driven
  double lost = 0.0;     ///< passengers
  std::string digest;    ///< of the day
};

/// The bound of a day without faults.
struct StudiedBound {
  std::string day;               ///< ISO 8601
  std::uint64_t seed = 0;        ///< of the run
  std::vector<Driving> corners;  ///< bound_corners
};

/// One city.
struct StudiedPart {
  std::string name;                  ///< in the benchmark
  std::string settings;              ///< of the entry (examined_settings)
  std::vector<StudiedDay> days;      ///< in the order of the part's sweep
  std::vector<StudiedBound> bounds;  ///< by day and seed
};

/// A study as far as it repeats.
struct StudyLine {
  std::string file;                ///< of the benchmark, as given
  std::string benchmark;           ///< its name
  std::string benchmark_digest;    ///< its digest
  std::string version;             ///< of evbal
  std::string controller;          ///< name of the entry's
  Command coordinator;             ///< its words as given; empty: evbal's own
  std::string coordinator_digest;  ///< of the files that it names
  std::vector<StudiedPart> parts;  ///< in the order of the benchmark
};

/// How the entry lies to the reference in one city under one schedule of faults.
struct StudyResult {
  std::string part;           ///< name
  std::string faults;         ///< name of the schedule
  std::string verdict;        ///< fewer, more, not shown, not comparable: passengers lost at equal idle km
  int days = 0;               ///< that could be compared
  double difference = 0.0;    ///< relative, of passengers lost
  double low = 0.0;           ///< its 95 % interval by t
  double high = 0.0;          ///< likewise
  std::optional<double> way;  ///< share of the way from the reference to the bound
};

/// What comes of a line's days; `sweeps` are those of the parts. Throws Error{bad_input} if a part has not the days of
/// its sweep.
std::vector<StudyResult> results_of(const StudyLine& line, const std::vector<Sweep>& sweeps);

/// fewer or more if some comparison says so and none the contrary, mixed if both are said, else not shown.
std::string verdict_of(const std::vector<StudyResult>& results);

/// The mean over the results that tell it.
std::optional<double> way_of(const std::vector<StudyResult>& results);

/// The line, with a line break at its end.
std::string line_text(const StudyLine& line, const std::vector<StudyResult>& results, double processor_seconds);

/// A line and what it says of its results.
struct ClaimedLine {
  StudyLine line;       ///< the days
  std::string results;  ///< JSON, to be held against results_text
};

/// The results as they stand in a line.
std::string results_text(const std::vector<StudyResult>& results);

/// Reads a line; `place` names it in messages. Throws Error{bad_input}, and Error{expectation_failed} if the digest
/// does not fit the content.
ClaimedLine read_line(const std::string& text, const std::string& place);

}  // namespace evbal
