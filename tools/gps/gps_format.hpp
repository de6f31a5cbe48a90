#pragma once

#include "tools/records/local_clock.hpp"
#include "tools/records/raw_table.hpp"
#include "tools/records/record_time.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace evbal {

/// When a vehicle that stands near a station is taken to charge (model, section 5, "Charging events from GPS").
struct ChargingRule {
  double within_m = 200.0;    ///< of the station,
  double longer_than = 30.0;  ///< minutes, without passengers
  double longest_gap = 15.0;  ///< minutes without a fix, which break the stay if
  double moved_m = 100.0;     ///< the vehicle moved further meanwhile
};

/// What GPS records do not say of themselves (docs/ingest.md): read from a small YAML file such as
/// tools/gps/san-francisco.yaml.
struct GpsFormat {
  TableFormat table;
  std::optional<std::size_t> vehicle;  ///< columns; without this one the file's name tells the vehicle:
  std::string file_prefix;             ///< what stands between these two, without .gz or .xz
  std::string file_suffix;
  std::size_t time = 0;
  std::size_t lat = 0;
  std::size_t lon = 0;
  std::size_t occupied = 0;
  TimeForm time_form = TimeForm::unix_seconds;
  std::string occupied_word;  ///< what the column `occupied` shows with passengers
  std::string free_word;      ///< and without
  LocalClock clock{0};
  ChargingRule charging;
};

/// Throws Error{bad_input} with file and line.
GpsFormat read_gps_format(const std::filesystem::path& file);

}  // namespace evbal
