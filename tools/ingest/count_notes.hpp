#pragma once

#include "agents/world/city.hpp"
#include "tools/ingest/fleet_stations.hpp"
#include "tools/ingest/sessions.hpp"
#include "tools/ingest/travel_sample.hpp"
#include "tools/ingest/zone_counts.hpp"

#include <filesystem>
#include <string>

namespace evbal {

/// What is needed to make a city of trip counts: read from a small YAML file such as tools/ingest/manhattan.yaml.
struct CountNotes {
  City city;                    ///< name, source, hours, days, fleet, passengers, the chargers' power
  std::string zone_field;       ///< field of the polygons whose values the tables name zones by
  CountFormat counts;           ///< layout of the tables of counts
  CountChoice choice;           ///< days and hours of the city, and the share of the trips
  SampleFormat sample;          ///< layout of the table of single trips
  FleetStations stations;       ///< the list of stations
  double snap_m = 500.0;        ///< stations up to this far outside the zones belong to the nearest
  SessionFormat session_table;  ///< layout of the tables of charging sessions
  SessionChoice sessions;       ///< whose lengths are those of the fleet
};

/// Reads such a file. Throws Error{bad_input} with file and line.
CountNotes read_count_notes(const std::filesystem::path& file);

}  // namespace evbal
