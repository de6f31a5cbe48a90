#pragma once

#include "agents/protocol/messages.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace evbal {

/// A count of a report that a sensor measures.
struct Measured {
  const char* name;              ///< in schedules and records
  std::int32_t Report::*member;  ///< where it stands in a report
};

/// All of them, in the order of ReportField.
inline constexpr std::array measured = {
    Measured{"vacant", &Report::vacant},           Measured{"low_battery", &Report::low_battery},
    Measured{"plugged", &Report::plugged},         Measured{"points", &Report::points},
    Measured{"waiting", &Report::waiting},         Measured{"demand", &Report::demand},
    Measured{"completions", &Report::completions}, Measured{"chargeable", &Report::chargeable}};

/// Position of a field among those measured; `field` is not `none`.
constexpr std::size_t index_of(ReportField field) {
  return static_cast<std::size_t>(field) - 1;
}

}  // namespace evbal
