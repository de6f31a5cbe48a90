#pragma once

#include "tools/ingest/ingest_trips.hpp"

#include <filesystem>

namespace evbal {

/// What ingest_counts reads.
struct CountSources {
  std::filesystem::path counts;    ///< folder of tables of trips by date, time and pair of zones (read_counts)
  std::filesystem::path zones;     ///< polygons to merge (read_zones)
  std::filesystem::path trips;     ///< table of single trips (fit_travel)
  std::filesystem::path stations;  ///< table of stations (ingest_stations)
  std::filesystem::path sessions;  ///< folder of charging sessions (read_sessions)
  std::filesystem::path notes;     ///< what the tables do not say (read_count_notes)
  int regions = 0;                 ///< as many as zones at most
};

/// Makes a city of trip counts. Its name gets the number of regions. Km and minutes between regions are those of the
/// fitted travel, with pace and detour of each hour weighed by the trips that start in it. Throws Error{bad_input}.
IngestedCity ingest_counts(const CountSources& sources);

}  // namespace evbal
