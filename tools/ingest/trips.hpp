#pragma once

#include "tools/ingest/notes.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace evbal {

/// One trip that counts.
struct Trip {
  int day = 0;   ///< position in City::days
  int step = 0;  ///< of the pick-up
  LatLon from;
  LatLon to;
  double minutes = 0.0;
  double km = 0.0;  ///< straight distance x CityNotes::detour
};

/// How many rows were dropped, by reason; and how many were read.
struct RowCount {
  long long read = 0;
  long long used = 0;
  std::map<std::string, long long> dropped;
};

/// Reads every trip table of `folder` as a stream, in the order of the files' names, and hands over the trips that
/// count. Columns: cab, pickup_unix, pickup_lat, pickup_lon, dropoff_unix, dropoff_lat, dropoff_lon (UTC seconds,
/// WGS84). Rows that do not count are dropped by reason. Throws Error{bad_input} on another header or a truncated
/// file.
RowCount for_each_trip(const std::filesystem::path& folder, const CityNotes& notes,
                       const std::function<void(const Trip&)>& use);

}  // namespace evbal
