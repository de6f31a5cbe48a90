#pragma once

#include "agents/world/geometry.hpp"
#include "tools/ingest/od_notes.hpp"
#include "tools/records/dropped.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace evbal {

/// Trips between cells; a cell is told by the degrees of its centre.
struct CellTrips {
  std::vector<LatLon> cells;                       ///< centres
  std::map<std::pair<int, int>, long long> trips;  ///< by the positions of two cells
  long long rows = 0;                              ///< read, dropped ones too
  Dropped dropped;                                 ///< rows, by reason

  /// What was read and what was dropped, in lines.
  std::string report() const;
};

/// Reads a table of trips between cells. Rows that are none are dropped and counted. Throws Error{bad_input}, with what
/// was dropped so far, if the file is no table of this format or all of its first rows are dropped.
CellTrips read_cell_trips(const std::filesystem::path& file, const OdFormat& format);

}  // namespace evbal
