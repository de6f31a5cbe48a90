#pragma once

#include "agents/protocol/tick_record.hpp"
#include "common/clock.hpp"

#include <cstdint>
#include <span>

namespace evbal {

/// How plans found out sensors that lied (docs/sensor-faults.md). A lie is what one sensor fault does to one region's
/// field, from the first report that it falsifies to its end.
struct Detection {
  std::int64_t lies = 0;            ///< of the day
  std::int64_t seen_60 = 0;         ///< of them, those whose region was flagged within 60 minutes
  std::int64_t found_30 = 0;        ///< whose region and field were flagged within 30 minutes
  std::int64_t found_60 = 0;        ///< likewise within 60
  std::int64_t found = 0;           ///< likewise before their end
  std::int64_t minutes = 0;         ///< that passed until these were found, in all
  std::int64_t large = 0;           ///< lies that came to be wrong by five or more within an hour
  std::int64_t large_found_60 = 0;  ///< of them, those whose region and field were flagged within 60 minutes
  std::int64_t false_alarms = 0;    ///< fields flagged in a region where no sensor fault acts, or has in the last hour
};

/// Compares the flags of the plans with the sensor faults among `ticks`, which start at tick 0 and leave none out.
Detection detection(const DayClock& clock, std::span<const TickRecord> ticks);

}  // namespace evbal
