#pragma once

#include "agents/world/city.hpp"
#include "tools/records/raw_table.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// How a list of stations is laid out.
struct StationFormat {
  bool open_charge_map = false;     ///< it is JSON of Open Charge Map (ChargeMapEntry); else a table
  TableFormat table;                ///< separator, header and columns
  std::size_t name = 0;             ///< column
  std::size_t lat = 0;              ///< column, WGS84 degrees
  std::size_t lon = 0;              ///< column, WGS84 degrees
  std::vector<std::size_t> points;  ///< columns, numbers of charging points that add up
};

/// Reads `layout` (table, open-charge-map; table unless given) and for a table the keys of read_table_format and
/// `columns`: {name, lat, lon, points}, where `points` is a column or a list of columns (docs/ingest.md).
StationFormat read_station_format(YamlMap& map);

/// What ingest_stations makes.
struct IngestedStations {
  std::vector<Station> stations;  ///< by region, then in the order of the list
  std::string report;             ///< what was read, dropped and why; one item a line
};

/// Puts the stations of a list into the regions that they lie in; those up to `snap_m` outside all regions into the
/// nearest. Rows of one name within 100 m are one station, whose points add up; further apart they are several, of
/// which all but the first get a number after their name. Rows that cannot be read, without points or too far out are
/// dropped. Throws Error{bad_input} with what was dropped, also if no row can be read or no station remains.
IngestedStations ingest_stations(const std::filesystem::path& file, const StationFormat& format,
                                 const std::vector<Region>& regions, double snap_m);

}  // namespace evbal
