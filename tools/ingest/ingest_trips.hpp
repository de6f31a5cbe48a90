#pragma once

#include "agents/world/city.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// What ingest_trips reads.
struct TripSources {
  std::filesystem::path trips;                ///< folder of trip tables (for_each_trip)
  std::filesystem::path format;               ///< of the tables (read_trip_format); empty: own_trip_format
  std::filesystem::path zones;                ///< polygons to merge (read_zones)
  std::filesystem::path sessions;             ///< folder of charging sessions (read_sessions)
  std::filesystem::path notes;                ///< what the records do not say (read_notes)
  int regions = 54;                           ///< with those apart
  std::filesystem::path session_format = {};  ///< of these (read_session_format); empty: dundee_session_format
};

/// What ingest_trips makes.
struct IngestedCity {
  City city;                    ///< without the demand of its days
  std::vector<DemandDay> days;  ///< the demand, by day
  std::string report;           ///< what was read, dropped and why; one item a line
};

/// Makes a city of trip records. The trips are streamed twice: once to weigh the zones, once to count between regions.
/// Throws Error{bad_input}.
IngestedCity ingest_trips(const TripSources& sources);

}  // namespace evbal
