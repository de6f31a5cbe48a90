#pragma once

#include "tools/records/raw_table.hpp"
#include "tools/records/record_time.hpp"

#include <filesystem>
#include <string>

namespace evbal {

/// How a table of trips is laid out and what its columns mean (docs/ingest.md).
struct TripFormat {
  /// Columns of a trip's start or end.
  struct End {
    std::size_t time = 0;
    std::size_t lat = 0;  ///< without zone_field
    std::size_t lon = 0;
    std::size_t zone = 0;  ///< with it
  };

  TableFormat table;
  TimeForm time_form = TimeForm::unix_seconds;
  End pickup;
  End dropoff;
  std::string zone_field;  ///< field of the polygons whose values stand in the columns `zone`; empty: degrees do
};

/// Throws Error{bad_input} with file and line.
TripFormat read_trip_format(const std::filesystem::path& file);

/// What `evbal ingest gps` writes: pickup_unix, pickup_lat, pickup_lon, dropoff_unix, dropoff_lat, dropoff_lon.
TripFormat own_trip_format();

}  // namespace evbal
