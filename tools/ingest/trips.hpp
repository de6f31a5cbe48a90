#pragma once

#include "tools/ingest/notes.hpp"
#include "tools/ingest/trip_format.hpp"
#include "tools/ingest/zones.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace evbal {

/// One trip that counts.
struct Trip {
  int day = 0;           ///< position in City::days
  int step = 0;          ///< of the pick-up
  LatLon from;           ///< of the pick-up
  LatLon to;             ///< of the drop-off
  double minutes = 0.0;  ///< from pick-up to drop-off
  double km = 0.0;       ///< straight distance x CityNotes::detour
};

/// How many rows were dropped, by reason; and how many were read.
struct RowCount {
  long long read = 0;                        ///< all rows
  long long used = 0;                        ///< rows that are trips
  std::map<std::string, long long> dropped;  ///< rows, by reason
};

/// Reads every trip table of `folder` as a stream, in the order of the files' names, and hands over the trips that
/// count. Ends that are known by zone are spread evenly over it: such a trip is never too fast. Rows that do not count
/// are dropped by reason. Throws Error{bad_input} with file and line if a file is truncated, lacks a column, or if all
/// of its first hundred rows are malformed.
RowCount for_each_trip(const std::filesystem::path& folder, const TripFormat& format, const std::vector<Zone>& zones,
                       const CityNotes& notes, const std::function<void(const Trip&)>& use);

}  // namespace evbal
