#pragma once

#include "tools/gps/fixes.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace evbal {

/// What ingest_gps reads.
struct GpsSources {
  std::filesystem::path gps;       ///< folder of tables of fixes, .csv or .txt, plain or compressed
  std::filesystem::path format;    ///< YAML (read_gps_format)
  std::filesystem::path regions;   ///< regions.geojson; empty: no transitions
  std::filesystem::path stations;  ///< YAML with a list `stations`, with `regions` only; empty: no charging stops
};

/// Makes tables of GPS fixes in `folder` and returns what was read, dropped and why, one item a line. The fixes are
/// streamed: memory does not grow with them. Throws Error{bad_input}, or Error{run_failed} if a table cannot be
/// written.
///
/// - `trips/trips.csv`, as for_each_trip reads it: a trip is from the first occupied fix to the next free one.
/// - `vacant.csv`: cab,from_unix,from_lat,from_lon,to_unix,to_lat,to_lon,km,ended_by (pickup, gap or records).
/// - `charging.csv`: cab,station,region,arrival_unix,start_unix,end_unix.
/// - `transitions.csv`: from,region,state,cars,becomes,in_region,share. Of the `cars` seen in a region and a state
///   (vacant; occupied, by destination) in the period that starts at `from`, the share that is in another half an hour
///   later.
std::string ingest_gps(const GpsSources& sources, const std::filesystem::path& folder,
                       const std::function<void(const FixProgress&)>& tell);

}  // namespace evbal
