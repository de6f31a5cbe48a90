#pragma once

#include "agents/world/city.hpp"
#include "tools/ingest/fleet_stations.hpp"

#include <filesystem>
#include <string>

namespace evbal {

/// A table of trips of one day between cells, without the time of day.
struct OdFormat {
  TableFormat table;         ///< separator, header and columns
  std::size_t from_lat = 0;  ///< columns
  std::size_t from_lon = 0;  ///< column
  std::size_t to_lat = 0;    ///< column
  std::size_t to_lon = 0;    ///< column
  std::size_t trips = 0;     ///< column, number of trips
  LatLon first{0.0, 0.0};    ///< centre of the cell whose columns are 0 (degrees are cells of one degree)
  LatLon step{1.0, 1.0};     ///< size of a cell, degrees

  /// Metres from south to north of a cell; 0 if columns are degrees.
  double cell_m() const { return step.lat < 1.0 ? step.lat * 111'195.0 : 0.0; }
};

/// What is needed to make a city of such a table: read from a small YAML file such as tools/ingest/shenzhen.yaml.
struct OdNotes {
  City city;                ///< name, source, fleet, passengers, the chargers' power; factors but for their tables
  OdFormat trips;           ///< layout of the table of trips
  double within_day = 1.0;  ///< share of a day's trips that start in the hours on record
  double snap_m = 500.0;    ///< cells and stations up to this far outside the zones belong to the nearest
  FleetStations stations;   ///< the list of stations
};

/// Reads such a file. Throws Error{bad_input} with file and line.
OdNotes read_od_notes(const std::filesystem::path& file);

}  // namespace evbal
