#pragma once

#include "agents/world/city.hpp"
#include "tools/gps/gps_format.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace evbal {

/// Where a vehicle was, and whether it carried passengers.
struct Fix {
  long long time = 0;  ///< UTC seconds
  /// WGS84.
  LatLon place;
  bool occupied = false;  ///< with passengers
};

/// How many rows were read, and dropped by reason.
struct FixCount {
  int files = 0;                             ///< tables read
  long long read = 0;                        ///< rows
  std::map<std::string, long long> dropped;  ///< rows, by reason
};

/// How far the reading has come.
struct FixProgress {
  int file = 0;        ///< that is being read, from 1
  int files = 0;       ///< in all
  long long rows = 0;  ///< read so far, of all files
};

/// Reads every table of `folder` as a stream, in the order of the files' names, and hands over the fixes with their
/// vehicle: each vehicle's ascend in time. Rows that do not count are dropped by reason: malformed, older than the
/// vehicle's fix before or of the same time, of a local time that the clocks skipped. A local time that clocks show
/// twice is the first one after the vehicle's fix before. `tell` is called at each file and every 100,000 rows.
/// Throws Error{bad_input} with file and line if a file is truncated, lacks a column, is not named as the format says,
/// or if all of its first hundred rows are malformed.
FixCount for_each_fix(const std::filesystem::path& folder, const GpsFormat& format,
                      const std::function<void(const std::string& vehicle, const Fix&)>& use,
                      const std::function<void(const FixProgress&)>& tell);

}  // namespace evbal
