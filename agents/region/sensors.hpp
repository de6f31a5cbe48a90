#pragma once

#include "agents/protocol/measured.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace evbal {

/// The numbers that sensors measure, as they really were when a report was made; by `measured`.
struct Reading {
  int tick = 0;  ///< of the report
  /// In the order of `measured`.
  std::array<std::int32_t, measured.size()> values{};
};

/// What a sensor fault holds on to.
struct HeldValue {
  int fault = 0;           ///< position in the resolved schedule
  std::int32_t value = 0;  ///< that the sensor is stuck at
};

/// What a region remembers of earlier reports, for sensors that are stuck or late.
struct SensorMemory {
  std::vector<Reading> readings;  ///< of the day's reports so far, by tick
  std::vector<HeldValue> stuck;   ///< of the sensor.stuck that are active
};

/// What a sensor reports that is off.
constexpr std::int32_t not_measured = -1;

/// The report that faulty sensors give in place of the true one. The effects act one after another; those of other
/// families are ignored. Adds to `observed`, by effect, how much each changed its field. Garbage is drawn from the
/// world's seed.
Report sensed(const Report& truth, const std::vector<Effect>& effects, int tick_minutes, std::uint64_t seed,
              SensorMemory& memory, std::vector<Observed>& observed);

}  // namespace evbal
