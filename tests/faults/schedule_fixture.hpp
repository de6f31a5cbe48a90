#pragma once

#include "faults/schedule/schedule.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace evbal::testing {

/// A day from 05:00 to 24:00 and five regions, of which 1, 3 and 4 have charging points, on two hosts.
inline FaultContext small_context() {
  return {DayClock{}, {0, 4, 0, 12, 20}, {{0, 1}, {2, 3, 4}}};
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) {
    throw std::logic_error("`" + from + "` is not in " + text);
  }
  return text.replace(at, from.size(), to);
}

inline const std::string spike =
    "{name: spike, type: demand.scale, target: {regions: [2, 0]}, start: \"17:30\", duration: 90min, magnitude: 1.8";
inline const std::string outage =
    "{name: outage, type: charger.outage, target: {regions: [1]}, start: \"07:30\", duration: 2h, "
    "magnitude: {fraction_of_points: 0.5}";

/// The head takes the first line, so that the faults begin on line 2.
inline std::string schedule_of(const std::vector<std::string>& faults, const std::string& head = "") {
  std::string text = "{schema: 1, seed: 7, " + head + "faults: [\n";
  for (const auto& fault : faults) {
    text += fault + "},\n";
  }
  return text + "]}\n";
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
