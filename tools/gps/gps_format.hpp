#pragma once

#include "tools/records/local_clock.hpp"
#include "tools/records/raw_table.hpp"
#include "tools/records/record_time.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace evbal {

/// When a vehicle that stands near a station is taken to charge (docs/model.md, section 5, "Charging events from GPS").
struct ChargingRule {
  double within_m = 200.0;    ///< metres from the station
  double longer_than = 30.0;  ///< minutes, without passengers
  double longest_gap = 15.0;  ///< minutes without a fix; a longer gap ends the stay if the vehicle moved
  double moved_m = 100.0;     ///< metres in a gap, beyond which the vehicle counts as moved
};

/// What GPS records do not say of themselves (docs/ingest.md): read from a small YAML file such as
/// tools/gps/san-francisco.yaml.
struct GpsFormat {
  TableFormat table;                            ///< separator, header and columns
  std::optional<std::size_t> vehicle;           ///< column; if there is none, the file's name holds the vehicle
  std::string file_prefix;                      ///< what stands before the vehicle in the file's name
  std::string file_suffix;                      ///< what stands after it, without the ending of a compression
  std::size_t time = 0;                         ///< column
  std::size_t lat = 0;                          ///< column
  std::size_t lon = 0;                          ///< column
  std::size_t occupied = 0;                     ///< column
  TimeForm time_form = TimeForm::unix_seconds;  ///< of the column `time`
  std::string occupied_word;                    ///< what the column `occupied` shows with passengers
  std::string free_word;                        ///< and without
  LocalClock clock{0};                          ///< of the place, for local times and periods of the day
  ChargingRule charging;                        ///< which stays count as charging
};

/// Reads such a file. Throws Error{bad_input} with file and line.
GpsFormat read_gps_format(const std::filesystem::path& file);

}  // namespace evbal
