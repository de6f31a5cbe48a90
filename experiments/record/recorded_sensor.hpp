#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// What a field of a region's report said at a plan, and what else is known of it.
struct SensorReading {
  int tick = 0;                   ///< of the plan
  int reported = 0;               ///< by the region
  std::optional<int> estimate{};  ///< by the coordinator, where it flagged the field
  std::optional<double> truth{};  ///< as agents said afterwards
};

/// A field of a region's report that plans flagged, over the whole day.
struct RecordedSensor {
  int region = 0;                         ///< whose report it is of
  std::string field;                      ///< as reports name it
  std::vector<std::string> kinds{};       ///< of lie, that plans named, each once, the most frequent first
  std::vector<SensorReading> readings{};  ///< by tick, of every report of the region
};

/// Reads the fields of a run.sqlite that were flagged, at most `most` of them, those that were flagged most often
/// first. Truth is known of vacant, low_battery, plugged and waiting, as the region stood when the tick before ended,
/// and of demand. Throws what SQLiteCpp throws.
std::vector<RecordedSensor> read_sensors(const std::filesystem::path& file, int most);

}  // namespace evbal
