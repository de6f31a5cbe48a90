#pragma once

#include "agents/world/city.hpp"
#include "tools/ingest/ingest_stations.hpp"

#include <filesystem>
#include <string>

namespace evbal {

/// The stations of a city that are on record, of which a fleet has a share.
struct FleetStations {
  StationFormat format;  ///< layout of their list
  double share = 1.0;    ///< of their points, for the fleet
};

/// Reads the keys of read_station_format, `share`, and the power of the points into `city`.
FleetStations read_fleet_stations(YamlMap& map, City& city);

/// Gives the city, which has its regions, the stations of a list (ingest_stations) with the fleet's share of their
/// points (share_of_points). Returns what was read, dropped and why, one item a line.
std::string add_stations(const std::filesystem::path& list, const FleetStations& stations, double snap_m, City& city);

}  // namespace evbal
