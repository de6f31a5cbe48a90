#include "faults/schedule/schedule.hpp"

#include "faults/schedule/draw.hpp"
#include "faults/schedule/entry.hpp"
#include "faults/schedule/fault_types.hpp"
#include "faults/schedule/guard.hpp"
#include "faults/schedule/request.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace evbal {
namespace {

std::vector<double> read_magnitudes(const YamlValue& value, const FaultType& type, const std::vector<int>& regions,
                                    const Place& place) {
  const auto items = value.items();
  if (items.size() != regions.size()) {
    throw value.error("expected one magnitude for each of the target's regions, " + std::to_string(regions.size()));
  }
  std::vector<double> magnitudes;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const bool points = type.magnitude == MagnitudeUnit::points;
    magnitudes.push_back(points ? items[i].integer(1, place.points_per_region[regions[i]])
                                : items[i].number(0.0, max_factor));
  }
  return magnitudes;
}

int read_ramp(const YamlValue& value, int duration) {
  const double ramp = value.duration();
  if (ramp != std::floor(ramp) || 2.0 * ramp > duration) {
    throw value.error("`" + value.text() + "` must be whole minutes, at most half of the duration");
  }
  return static_cast<int>(ramp);
}

Fault read_fault(const YamlValue& entry, const Place& place) {
  YamlMap map(entry);
  Fault fault;
  fault.name = read_name(map);
  const FaultType& type = fault_types()[map.require("type").one_of(fault_type_names())];
  fault.type = type.effect;
  YamlMap target(map.require("target"));
  fault.regions = read_regions(target.require("regions"), place, type.magnitude == MagnitudeUnit::points);
  target.finish();
  fault.magnitudes = read_magnitudes(map.require("magnitude"), type, fault.regions, place);
  const auto start = map.require("start");
  fault.start = start.time_of_day() - place.clock.start;
  if (fault.start < 0 || fault.start >= place.clock.minutes()) {
    throw start.error("`" + start.text() + "` is outside of the day; give a time from " + time_of_day(place.clock, 0) +
                      ", before " + time_of_day(place.clock, place.clock.minutes()));
  }
  fault.duration = map.require("duration").whole_minutes();
  if (type.ramp) {
    fault.ramp = read_ramp(map.require("ramp"), fault.duration);
  }
  if (type.on_start) {
    fault.on_start = static_cast<OnStart>(map.require("on_start").one_of(on_start_words()));
  }
  fault.visible = map.require("visible").boolean();
  map.finish();
  return fault;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return "[" + text + "]";
}

/// The shortest decimal that reads back as the same number.
std::string exact(double x) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

std::string fault_yaml(const Fault& fault, const DayClock& clock) {
  const FaultType& type = fault_type(fault.type);
  std::vector<std::string> regions;
  std::vector<std::string> magnitudes;
  for (std::size_t i = 0; i < fault.regions.size(); ++i) {
    regions.push_back(std::to_string(fault.regions[i]));
    magnitudes.push_back(exact(fault.magnitudes[i]));
  }
  std::string yaml = "  - name: \"" + fault.name + "\"\n    type: " + type.name + "\n";
  yaml += "    target: {regions: " + joined(regions) + "}\n    magnitude: " + joined(magnitudes) + "\n";
  yaml += "    start: \"" + time_of_day(clock, fault.start) + "\"\n";
  yaml += "    duration: " + std::to_string(fault.duration) + "min\n";
  yaml += type.ramp ? "    ramp: " + std::to_string(fault.ramp) + "min\n" : "";
  yaml += type.on_start ? "    on_start: " + on_start_words()[static_cast<std::size_t>(fault.on_start)] + "\n" : "";
  return yaml + "    visible: " + (fault.visible ? "true" : "false") + "\n";
}

}  // namespace

Schedule read_schedule(YamlMap& map, const Place& place) {
  map.require("schema").integer(1, 1);
  const auto resolved_key = map.find("resolved");
  const bool resolved = resolved_key && resolved_key->boolean();
  Schedule schedule;
  if (const auto seed = map.find("seed")) {
    schedule.seed = seed->seed();
  }
  if (const auto guard = map.find("guard")) {
    schedule.guard = read_guard(*guard);
  }
  std::vector<PlacedFault> placed;
  for (const auto& entry : map.require("faults").items()) {
    if (resolved) {
      placed.push_back({read_fault(entry, place), entry});
      continue;
    }
    for (auto& fault : draw_faults(read_request(entry, place), place, schedule.seed)) {
      placed.push_back({std::move(fault), entry});
    }
  }
  check_guard(schedule.guard, placed, place);
  for (auto& fault : placed) {
    schedule.faults.push_back(std::move(fault.fault));
  }
  return schedule;
}

Schedule read_resolved(YamlMap& scenario, const Place& place) {
  YamlMap map(scenario.require("faults"));
  const auto resolved = map.require("resolved");
  if (!resolved.boolean()) {
    throw resolved.error("the faults must be drawn already; give a resolved scenario");
  }
  auto schedule = read_schedule(map, place);
  map.finish();
  return schedule;
}

std::string schedule_yaml(const Schedule& schedule, const DayClock& clock) {
  std::string yaml = "schema: 1\nresolved: true\nseed: " + std::to_string(schedule.seed) + "\n";
  yaml += "guard: {max_active: " + std::to_string(schedule.guard.max_active) +
          ", min_working_points: " + std::to_string(schedule.guard.min_working_points) + ", overlap: reject}\n";
  if (schedule.faults.empty()) {
    return yaml + "faults: []\n";
  }
  yaml += "faults:\n";
  for (const auto& fault : schedule.faults) {
    yaml += fault_yaml(fault, clock);
  }
  return yaml;
}

}  // namespace evbal
