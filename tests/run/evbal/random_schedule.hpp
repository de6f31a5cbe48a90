#pragma once

#include "common/random.hpp"

#include <array>
#include <string>
#include <utility>

namespace evbal {

/// Every type of fault with fields that fit toy-5 and San Francisco, but for name, start and duration.
inline const std::array<std::pair<const char*, const char*>, 25>& fault_fields() {
  static const std::array<std::pair<const char*, const char*>, 25> fields{
      {{"demand.scale", "target: {pick: 2}, magnitude: {uniform: {min: 0, max: 4}}, ramp: 5min"},
       {"demand.add", "target: {pick: 2}, magnitude: {uniform: {min: 0, max: 90}}"},
       {"demand.shift", "target: {pick: 3}, magnitude: {uniform: {min: 0, max: 1}}, to: 1"},
       {"charger.outage", "target: {pick: 2}, magnitude: {fraction_of_points: 0.7}, on_start: evict"},
       {"charger.derate", "target: {pick: 2}, magnitude: {uniform: {min: 0, max: 1}}"},
       {"charger.block", "target: {pick: 1}, magnitude: {fraction_of_points: 1.0}"},
       {"charger.no_start", "target: {pick: 2}, probability: {uniform: {min: 0.2, max: 1}}"},
       {"fleet.breakdown", "target: {pick: 2}, magnitude: {vehicles: {uniform: {min: 1, max: 9}}}, visible: false"},
       {"fleet.drain", "target: {pick: 2}, magnitude: {uniform: {min: 1, max: 5}}, visible: false"},
       {"travel.slow", "target: {pick: 3}, magnitude: {uniform: {min: 1, max: 4}}, ramp: 5min"},
       {"sensor.stuck", "target: {pick: 2, of: {regions: [0, 1, 2]}, field: low_battery}"},
       {"sensor.garbage", "target: {pick: 2, field: vacant}"},
       {"sensor.biased", "target: {pick: 2, field: plugged}, magnitude: {normal: {mean: 0, sd: 4}}"},
       {"sensor.noisy", "target: {pick: 3, field: demand}, magnitude: 5"},
       {"sensor.delayed", "target: {pick: 2, field: waiting}, magnitude: {uniform: {min: 10min, max: 60min}}"},
       {"sensor.off", "target: {pick: 1, field: points}"},
       {"process.kill", "target: {pick: 1}"},
       {"process.pause", "target: {coordinator: true}"},
       {"process.slow", "target: {pick: 2}, magnitude: {uniform: {min: 1min, max: 5min}}"},
       {"network.drop", "target: {topic: report, fraction: 0.4}, probability: 0.5"},
       {"network.delay", "target: {topic: plan, pick: 2}, magnitude: 3min"},
       {"network.partition", "target: {pick: 2}"},
       {"solver.fail", ""},
       {"solver.starve", "magnitude: {iterations: {uniform: {min: 1, max: 5}}}"},
       {"host.down", "target: {regions: [1, 2]}"}}};
  return fields;
}

/// Whether a type of fault is said to be over by `restart_after`.
inline bool comes_back(const std::string& type) {
  return type == "process.kill" || type == "host.down";
}

/// When the faults of a random schedule begin, and how many there are.
struct Extent {
  std::string from;
  std::string to;
  std::uint64_t most = 6;
};

/// A schedule of a few faults. Some overlap and are refused: then another is to be asked for.
inline std::string random_schedule(std::uint64_t seed, const Extent& extent) {
  RandomStream stream(seed, Purpose::fault, {});
  std::string text = "schema: 1\nseed: " + std::to_string(seed) + "\nfaults:\n";
  const std::uint64_t count = 1 + stream.below(extent.most);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto& [type, own] = fault_fields().at(stream.below(fault_fields().size()));
    const bool kill = comes_back(type);
    text += "  - {name: f" + std::to_string(i) + ", type: " + type + ", ";
    text += "start: {uniform: {min: \"" + extent.from + "\", max: \"" + extent.to + "\"}}, ";
    text += std::string(kill ? "restart_after" : "duration") + ": {exponential: {mean: 40min}}";
    text += std::string(*own == '\0' ? "" : ", ") + own + "}\n";
  }
  return text;
}

}  // namespace evbal
