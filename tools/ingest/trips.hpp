#pragma once

#include "tools/ingest/notes.hpp"
#include "tools/ingest/trip_format.hpp"
#include "tools/ingest/zones.hpp"
#include "tools/records/dropped.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

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

/// How many rows were read, used and dropped.
struct RowCount {
  long long read = 0;             ///< all rows
  long long used = 0;             ///< rows that are trips and count
  Dropped dropped;                ///< the others
  int unused_files = 0;           ///< tables that have rows, none of which was used
  std::string first_unused_file;  ///< of them

  /// One item a line.
  std::string report() const;
};

/// Takes a trip. Returns why it does not count after all, or nothing.
using UseTrip = std::function<std::string_view(const Trip&)>;

/// Reads every trip table of `folder` as a stream, in the order of the files' names, and hands over the trips that
/// count. Ends that are known by zone are spread evenly over it: such a trip is never too fast. Rows that do not count
/// are dropped by reason. Throws Error{bad_input} with file and line, and what was read before, if a file is truncated,
/// lacks a column, or if none of its rows, or of its first hundred, can be read.
RowCount for_each_trip(const std::filesystem::path& folder, const TripFormat& format, const std::vector<Zone>& zones,
                       const CityNotes& notes, const UseTrip& use);

}  // namespace evbal
