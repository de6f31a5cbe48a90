#pragma once

#include "agents/world/city.hpp"
#include "tools/gps/gps_format.hpp"
#include "tools/records/dropped.hpp"

#include <filesystem>
#include <functional>
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
  int files = 0;       ///< tables read
  int backwards = 0;   ///< tables of them whose rows run from the newest to the oldest
  long long read = 0;  ///< rows
  long long used = 0;  ///< rows handed over
  Dropped dropped;     ///< the others
};

/// How far the reading has come.
struct FixProgress {
  int file = 0;        ///< that is being read, from 1
  int files = 0;       ///< in all
  long long rows = 0;  ///< read so far, of all files
};

/// Takes a fix of a vehicle. `goes_on` is false for its first, and where a car cannot have driven from the fix before:
/// another part of its records begins.
using UseFix = std::function<void(const std::string& vehicle, const Fix& fix, bool goes_on)>;

/// Reads every table of `folder` as a stream, in the order of the files' names, and hands over the fixes with their
/// vehicle: each vehicle's ascend in time. A table that runs from the newest fix to the oldest is read backwards.
/// Rows that do not count are dropped by reason: unreadable, at 0,0, out of the order of time, of the same time as
/// another, where no car can have driven (longest_drive), of a local time that the clocks skipped. A local time that
/// clocks show twice is the first one after the vehicle's fix before. `tell` is called at each file and every 100,000
/// rows. Throws Error{bad_input} with file and line, and with what was dropped so far, if a file is truncated, lacks a
/// column or is not named as the format says, if all of its first hundred rows are unreadable, if more than a tenth
/// of its rows are out of the order of time, if no fix remains, or if most of them are where no car can have driven.
FixCount for_each_fix(const std::filesystem::path& folder, const GpsFormat& format, const UseFix& use,
                      const std::function<void(const FixProgress&)>& tell);

}  // namespace evbal
