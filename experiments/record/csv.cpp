#include "experiments/record/csv.hpp"

#include "common/decimal.hpp"
#include "common/table_text.hpp"
#include "experiments/metrics/columns.hpp"

#include <vector>

namespace evbal {
namespace {

template <class Line>
std::string csv(const DayClock& clock, const std::vector<Line>& lines) {
  std::vector<std::string> cells = {"start"};
  columns([&](const char* name, auto) { cells.emplace_back(name); }, Line{});
  std::string text = csv_row(cells);
  for (const auto& line : lines) {
    cells = {time_of_day(clock, line.step * clock.step)};
    columns([&](const char*, auto value) { cells.push_back(decimal(value)); }, line);
    text += csv_row(cells);
  }
  return text;
}

}  // namespace

std::string steps_csv(const DayClock& clock, const DayMetrics& day) {
  return csv(clock, day.steps);
}

std::string regions_csv(const DayClock& clock, const DayMetrics& day) {
  return csv(clock, day.regions);
}

}  // namespace evbal
