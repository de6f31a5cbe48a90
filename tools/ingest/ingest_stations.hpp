#pragma once

#include "agents/city/city.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

struct StationSources {
  std::filesystem::path table;   ///< of stations, one a row
  std::filesystem::path format;  ///< YAML: separator, header, columns {name, lat, lon, points} (docs/ingest.md)
};

struct IngestedStations {
  std::vector<Station> stations;  ///< by region, then in the order of the table
  std::string report;             ///< what was read, dropped and why; one item a line
};

/// Puts the stations of a table into the regions that they lie in; those up to `snap_m` outside all regions into the
/// nearest. Rows without points or too far out are dropped. Throws Error{bad_input}, also if no station remains.
IngestedStations ingest_stations(const StationSources& sources, const std::vector<Region>& regions, double snap_m);

}  // namespace evbal
