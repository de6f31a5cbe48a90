#pragma once

#include "faults/schedule/schedule.hpp"

#include <cassert>
#include <string>

namespace evbal::testing {

/// A day from 05:00 to 24:00 and five regions, of which 1, 3 and 4 have charging points.
inline FaultContext small_context() {
  return {DayClock{}, {0, 4, 0, 12, 20}};
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  assert(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

inline std::vector<Schedule> read_runs(const std::string& text, const FaultContext& context = small_context()) {
  YamlMap map(YamlValue::parse(text, "faults.yaml"));
  auto schedules = read_schedules(map, context);
  map.finish();
  return schedules;
}

inline Schedule read_text(const std::string& text, const FaultContext& context = small_context()) {
  return read_runs(text, context).front();
}

}  // namespace evbal::testing
