#pragma once

#include "tools/ingest/zones.hpp"
#include "tools/records/dropped.hpp"
#include "tools/records/raw_table.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// How tables of trip counts by date, time and pair of zones are laid out (docs/ingest.md).
struct CountFormat {
  TableFormat table;              ///< separator, header and columns
  std::vector<std::size_t> time;  ///< columns that tell together when the trips start, as clocks show it
  std::string pattern;            ///< of that time, as time_like takes it
  std::size_t from = 0;           ///< column, zone
  std::size_t to = 0;             ///< column, zone
  std::size_t trips = 0;          ///< column, number of trips
};

/// Which trips of the tables are taken.
struct CountChoice {
  std::vector<std::string> days;  ///< ISO dates, ascending
  int day_start = 0;              ///< minute after midnight
  int step_minutes = 30;          ///< of the demand
  double share = 1.0;             ///< of the trips, each of which is drawn by itself
  std::uint64_t seed = 1;         ///< of the draw
};

/// Trips of one day and step from one zone to another.
struct ZoneCount {
  int day = 0;    ///< position in CountChoice::days
  int step = 0;   ///< of the day, from its start
  int from = 0;   ///< zone
  int to = 0;     ///< zone
  int trips = 0;  ///< at least one
};

/// What read_counts makes.
struct ZoneCounts {
  std::vector<ZoneCount> cells;  ///< by day, step, from and to
  std::string report;            ///< what was read, dropped, added up and drawn; one item a line
};

/// Reads every table of `folder` and thins the counts. Rows of the same cell add up. Equal tables give equal draws, in
/// whatever order their rows stand. Throws Error{bad_input} with what was dropped, also if a day or a step of all days
/// has no trip.
ZoneCounts read_counts(const std::filesystem::path& folder, const CountFormat& format, const std::vector<Zone>& zones,
                       const CountChoice& choice);

}  // namespace evbal
