#pragma once

#include "tools/gps/fixes.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace evbal {

struct GpsSources {
  std::filesystem::path gps;       ///< folder of tables of fixes, .csv or .txt, plain, .gz or .xz
  std::filesystem::path format;    ///< YAML (read_gps_format)
  std::filesystem::path regions;   ///< regions.geojson; empty: no transitions
  std::filesystem::path stations;  ///< YAML with a list `stations`, with `regions` only; empty: no charging stops
};

/// Makes of GPS fixes the tables below, written as they are found into `folder`, and returns what was read, dropped and
/// why; one item a line. Memory does not grow with the fixes. Throws Error{bad_input}, or Error{run_failed} if a table
/// cannot be written.
///   trips/trips.csv  as for_each_trip reads them: a change to occupied opens a trip at the first occupied fix, a
///   change
///                    to free closes it at the first free fix
///   vacant.csv       cab,from_unix,from_lat,from_lon,to_unix,to_lat,to_lon,km,ended_by (pickup, gap or records)
///   charging.csv     cab,station,region,arrival_unix,start_unix,end_unix
///   transitions.csv  from,region,state,cars,becomes,in_region,share: of the cars that are in a region and a state
///   (vacant;
///                    occupied, by destination) in the period that starts at `from`, the share that is in another half
///                    an hour later; `cars` were seen
std::string ingest_gps(const GpsSources& sources, const std::filesystem::path& folder,
                       const std::function<void(const FixProgress&)>& tell);

}  // namespace evbal
