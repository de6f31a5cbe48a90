#pragma once

#include "agents/world/city.hpp"
#include "tools/ingest/sessions.hpp"
#include "tools/records/local_clock.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// What raw records do not say about a city: read from a small YAML file such as tools/ingest/san-francisco.yaml.
struct CityNotes {
  City city;            ///< name, source, hours, days, fleet, passengers and the chargers' power
  LocalClock clock{0};  ///< of the city

  double shortest_minutes = 1.0;   ///< shorter trips are dropped
  double longest_minutes = 120.0;  ///< longer trips are dropped
  double fastest_kmh = 120.0;      ///< faster trips are dropped, by the straight line

  double detour = 1.3;     ///< driven distance over straight distance
  double reach_km = 20.0;  ///< zones further than this from the mean pick-up are left out
  double snap_m = 500.0;   ///< trip ends up to this far outside the zones belong to the nearest

  /// A place whose zone becomes a region of its own, such as an airport.
  struct Apart {
    std::string name;  ///< of the region
    LatLon place;      ///< in the zone
  };
  std::vector<Apart> apart;  ///< zones that become regions of their own

  int stations = 0;  ///< to place
  int points = 0;    ///< of all stations, >= stations

  SessionChoice sessions;  ///< whose lengths are those of the fleet
};

/// Reads such a file. Throws Error{bad_input} with file and line.
CityNotes read_notes(const std::filesystem::path& file);

}  // namespace evbal
