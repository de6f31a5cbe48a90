#include "experiments/record/csv.hpp"

#include "experiments/metrics/columns.hpp"
#include "experiments/record/text.hpp"

#include <vector>

namespace evbal {
namespace {

template <class Line>
std::string csv(const DayClock& clock, const std::vector<Line>& lines) {
  std::string text = "start";
  columns([&](const char* name, auto) { text.append(",").append(name); }, Line{});
  for (const auto& line : lines) {
    text.append("\n").append(time_of_day(clock, line.step * clock.step));
    columns([&](const char*, auto value) { text.append(",").append(shortest(value)); }, line);
  }
  return text + "\n";
}

}  // namespace

std::string steps_csv(const DayClock& clock, const DayMetrics& day) {
  return csv(clock, day.steps);
}

std::string regions_csv(const DayClock& clock, const DayMetrics& day) {
  return csv(clock, day.regions);
}

}  // namespace evbal
