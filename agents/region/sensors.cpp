#include "agents/region/sensors.hpp"

#include "common/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evbal {
namespace {

std::int32_t bounded(double value) {
  using Limits = std::numeric_limits<std::int32_t>;
  return static_cast<std::int32_t>(
      std::lround(std::clamp(value, static_cast<double>(Limits::min()), static_cast<double>(Limits::max()))));
}

/// Half of it anything that fits in the message, half of it what looks like a number of cars.
std::int32_t garbage(RandomStream& stream) {
  constexpr double likely_low = -10.0;
  constexpr double likely_high = 1000.0;
  return stream.uniform() < 0.5 ? static_cast<std::int32_t>(static_cast<std::uint32_t>(stream.bits()))
                                : bounded(stream.uniform(likely_low, likely_high));
}

/// As it was `minutes` ago: in the last report that is at least so old, else in the first.
std::int32_t earlier(const SensorMemory& memory, ReportField field, double minutes, int tick, int tick_minutes) {
  const Reading* found = &memory.readings.front();
  for (const auto& reading : memory.readings) {
    found = (tick - reading.tick) * tick_minutes >= minutes ? &reading : found;
  }
  return found->values.at(index_of(field));
}

std::int32_t held(SensorMemory& memory, int fault, std::int32_t now) {
  const auto known = std::ranges::find(memory.stuck, fault, &HeldValue::fault);
  if (known != memory.stuck.end()) {
    return known->value;
  }
  memory.stuck.push_back({.fault = fault, .value = now});
  return now;
}

void forget_ended(SensorMemory& memory, const std::vector<Effect>& effects) {
  std::erase_if(memory.stuck, [&](const HeldValue& value) {
    return std::ranges::none_of(effects, [&](const Effect& effect) { return effect.fault == value.fault; });
  });
}

}  // namespace

Report sensed(const Report& truth, const std::vector<Effect>& effects, int tick_minutes, std::uint64_t seed,
              SensorMemory& memory, std::vector<Observed>& observed) {
  Reading& now = memory.readings.emplace_back();
  now.tick = truth.tick;
  std::ranges::transform(measured, now.values.begin(), [&](const Measured& count) { return truth.*count.member; });
  forget_ended(memory, effects);
  Report said = truth;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const Effect& effect = effects[i];
    if (family_of(effect.type) != FaultFamily::sensor) {
      continue;
    }
    RandomStream stream(seed, Purpose::sensor,
                        {.region = static_cast<std::uint64_t>(truth.region),
                         .tick = static_cast<std::uint64_t>(truth.tick),
                         .index = static_cast<std::uint64_t>(effect.fault)});
    std::int32_t& value = said.*measured.at(index_of(effect.field)).member;
    const std::int32_t before = value;
    switch (effect.type) {
      case EffectType::sensor_stuck:
        value = held(memory, effect.fault, value);
        break;
      case EffectType::sensor_garbage:
        value = garbage(stream);
        break;
      case EffectType::sensor_biased:
        value = bounded(before + effect.magnitude);
        break;
      case EffectType::sensor_noisy:
        value = bounded(before + effect.magnitude * stream.normal());
        break;
      case EffectType::sensor_delayed:
        value = earlier(memory, effect.field, effect.magnitude, truth.tick, tick_minutes);
        break;
      default:
        value = not_measured;
    }
    observed[i].amount += static_cast<double>(value) - before;
  }
  return said;
}

}  // namespace evbal
