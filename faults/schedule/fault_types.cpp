#include "faults/schedule/fault_types.hpp"

#include "agents/protocol/words.hpp"

#include <cassert>

namespace evbal {
namespace {

constexpr double most_passengers_an_hour = 10000.0;
constexpr double most_vehicles = 10000.0;
constexpr double most_times = 10.0;  // as slow, or as much energy
constexpr double most_error = 1000.0;
constexpr double most_minutes = 24.0 * 60.0;
constexpr double most_iterations = 1e6;

/// One row a type, in the order of EffectType; the head of fault_types.hpp says what else a new one needs.
std::vector<FaultType> all_types() {
  using enum EffectType;
  using enum TargetKind;
  using enum MagnitudeUnit;
  const Range lateness{1.0, most_minutes};
  return {
      {.name = "demand.scale", .effect = demand_scale, .range = {0.0, max_factor}, .neutral = 1.0, .ramp = true},
      {.name = "charger.outage",
       .effect = charger_outage,
       .target = stations,
       .unit = count,
       .counted = "points",
       .on_start = true},
      {.name = "demand.add", .effect = demand_add, .range = {0.0, most_passengers_an_hour}, .ramp = true},
      {.name = "demand.shift", .effect = demand_shift, .range = {0.0, 1.0}, .ramp = true, .to = true},
      {.name = "charger.derate",
       .effect = charger_derate,
       .target = stations,
       .range = {0.0, 1.0},
       .neutral = 1.0,
       .ramp = true},
      {.name = "charger.block", .effect = charger_block, .target = stations, .unit = count, .counted = "points"},
      {.name = "fleet.breakdown",
       .effect = fleet_breakdown,
       .unit = count,
       .range = {1.0, most_vehicles},
       .counted = "vehicles"},
      {.name = "fleet.drain", .effect = fleet_drain, .range = {1.0, most_times}, .neutral = 1.0, .ramp = true},
      {.name = "travel.slow", .effect = travel_slow, .range = {1.0, most_times}, .neutral = 1.0, .ramp = true},
      {.name = "sensor.stuck", .effect = sensor_stuck, .target = sensors, .unit = none},
      {.name = "sensor.garbage", .effect = sensor_garbage, .target = sensors, .unit = none},
      {.name = "sensor.biased", .effect = sensor_biased, .target = sensors, .range = {-most_error, most_error}},
      {.name = "sensor.noisy", .effect = sensor_noisy, .target = sensors, .range = {0.0, most_error}},
      {.name = "sensor.delayed", .effect = sensor_delayed, .target = sensors, .unit = minutes, .range = lateness},
      {.name = "sensor.off", .effect = sensor_off, .target = sensors, .unit = none},
      {.name = "process.kill", .effect = process_kill, .target = processes, .unit = none, .duration = "restart_after"},
      {.name = "process.pause", .effect = process_pause, .target = processes, .unit = none},
      {.name = "process.slow", .effect = process_slow, .target = processes, .unit = minutes, .range = lateness},
      {.name = "network.drop",
       .effect = network_drop,
       .target = topics,
       .range = {0.0, 1.0},
       .magnitude = "probability"},
      {.name = "network.delay", .effect = network_delay, .target = topics, .unit = minutes, .range = lateness},
      {.name = "network.partition", .effect = network_partition, .target = links, .unit = none},
      {.name = "solver.fail", .effect = solver_fail, .target = engine, .unit = none},
      {.name = "solver.starve",
       .effect = solver_starve,
       .target = engine,
       .unit = count,
       .range = {1.0, most_iterations},
       .counted = "iterations"},
      {.name = "charger.no_start",
       .effect = charger_no_start,
       .target = stations,
       .range = {0.0, 1.0},
       .magnitude = "probability"},
      {.name = "host.down", .effect = host_down, .target = hosts, .unit = none, .duration = "restart_after"},
  };
}

}  // namespace

const std::vector<FaultType>& fault_types() {
  static const std::vector<FaultType> types = all_types();
  return types;
}

std::vector<std::string> fault_type_names() {
  std::vector<std::string> names;
  for (const auto& type : fault_types()) {
    names.push_back(type.name);
  }
  return names;
}

const FaultType& fault_type(EffectType effect) {
  const FaultType& type = fault_types().at(static_cast<std::size_t>(effect));
  assert(type.effect == effect);
  return type;
}

std::vector<std::string> report_field_words() {
  std::vector<std::string> fields = words<ReportField>();
  fields.erase(fields.begin());
  return fields;
}

}  // namespace evbal
