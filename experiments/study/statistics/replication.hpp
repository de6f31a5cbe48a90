#pragma once

#include "experiments/study/design/finished_day.hpp"

#include <cstdint>
#include <string>
#include <tuple>

namespace evbal {

/// What days of different variants must share to be compared: scenario, faults, day and seed.
using Replication = std::tuple<std::string, std::string, std::string, std::uint64_t>;

/// The replication that a day belongs to.
inline Replication replication_of(const FinishedDay& day) {
  return {day.scenario, day.faults, day.day, day.seed};
}

}  // namespace evbal
