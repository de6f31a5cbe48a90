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
    std::size_t time = 0;  ///< column
    std::size_t lat = 0;   ///< column, if there is no zone_field
    std::size_t lon = 0;   ///< likewise
    std::size_t zone = 0;  ///< column, if there is a zone_field
  };

  TableFormat table;                            ///< separator, header and columns
  TimeForm time_form = TimeForm::unix_seconds;  ///< of the columns `time`
  End pickup;                                   ///< columns of the trip's start
  End dropoff;                                  ///< columns of the trip's end
  std::string zone_field;  ///< field of the polygons that the columns `zone` name; empty: places are in degrees
};

/// Reads such a file. Throws Error{bad_input} with file and line.
TripFormat read_trip_format(const std::filesystem::path& file);

/// What `evbal ingest gps` writes: pickup_unix, pickup_lat, pickup_lon, dropoff_unix, dropoff_lat, dropoff_lon.
TripFormat own_trip_format();

}  // namespace evbal
