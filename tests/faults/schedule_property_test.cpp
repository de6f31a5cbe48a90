#include "agents/protocol/words.hpp"
#include "faults/schedule/fault_types.hpp"
#include "tests/faults/schedule_fixture.hpp"
#include "tests/support/yaml_of.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

namespace evbal {
namespace {

using testing::read_text;
using testing::small_context;

std::string one_of(std::vector<std::string> texts) {
  return *rc::gen::elementOf(std::move(texts));
}

std::string schedule_yaml(const Schedule& schedule, const DayClock& clock) {
  return yaml_of([&](YamlWriter& yaml) { write_schedule(yaml, schedule, clock); });
}

std::string random_where() {
  return one_of({"pick: 1", "regions: [3]", "regions: [4, 1]", "pick: 2, of: {min_points: 5}"});
}

std::string random_target(const FaultType& type) {
  switch (type.target) {
    case TargetKind::engine:
      return "";
    case TargetKind::sensors:
      return "target: {" + random_where() + ", field: " + one_of(report_field_words()) + "}, ";
    case TargetKind::processes:
      return "target: " +
             one_of({"{agent: 2}", "{agents: [0, 4]}", "{pick: 3}", "{coordinator: true}", "{injector: true}"}) + ", ";
    case TargetKind::hosts:
      return "target: {host: " + one_of({"0", "1"}) + "}, ";
    case TargetKind::topics:
      return "target: {topic: " + one_of(words<NetworkTopic>()) + one_of({"", ", regions: [3]", ", fraction: 0.5"}) +
             "}, ";
    case TargetKind::regions:
    case TargetKind::stations:
    case TargetKind::links:
      break;
  }
  return "target: {" + random_where() + "}, ";
}

std::string random_magnitude(const FaultType& type) {
  const std::string key = type.magnitude + ": ";
  switch (type.unit) {
    case MagnitudeUnit::none:
      return "";
    case MagnitudeUnit::minutes:
      return key + one_of({"7min", "{exponential: {mean: 20min}}"}) + ", ";
    case MagnitudeUnit::count:
      return key +
             (type.counts_points() ? one_of({"{fraction_of_points: 0.3}", "{points: {uniform: {min: 1, max: 4}}}"})
                                   : "{" + type.counted + ": {uniform: {min: 1, max: 9}}}") +
             ", ";
    case MagnitudeUnit::number:
      break;
  }
  return key +
         one_of({"1", "{uniform: {min: 1, max: 1}}", "{normal: {mean: 1, sd: 0.7}}", "{exponential: {mean: 1}}"}) +
         ", ";
}

/// A fault whose every field may be a value or a distribution. Short and rare, so that the guard mostly holds.
std::string random_fault(int index) {
  const FaultType& type = *rc::gen::elementOf(fault_types());
  std::string text = "  - {name: f" + std::to_string(index) + ", type: " + type.name + ", " + random_target(type) +
                     random_magnitude(type) + (type.to ? "to: 2, " : "");
  text += one_of({"start: \"06:10\"", "start: {uniform: {min: \"06:00\", max: \"23:59\"}}",
                  "start: {normal: {mean: \"12:00\", sd: 4h}}", "arrivals: {poisson: {per_hour: 0.1}}"});
  text += ", " + type.duration + ": " +
          one_of({"7min", "2h", "{exponential: {mean: 20min}}", "{lognormal: {median: 40min, sigma: 0.6, max: 3h}}"});
  text += type.ramp ? one_of({"", ", ramp: 3min", ", ramp: {uniform: {min: 0min, max: 30min}}"}) : "";
  text += type.on_start ? one_of({"", ", on_start: evict", ", on_start: drain"}) : "";
  return text + (type.may_be_invisible() ? one_of({"", ", visible: false"}) : "") + "}\n";
}

std::string random_request(std::uint64_t seed) {
  std::string text = "schema: 1\nseed: " + std::to_string(seed) + "\nfaults:\n";
  const int count = *rc::gen::inRange(1, 5);
  for (int i = 0; i < count; ++i) {
    text += random_fault(i);
  }
  return text;
}

/// Draws a request until one passes the guard.
Schedule random_schedule() {
  while (true) {
    try {
      return read_text(random_request(*rc::gen::arbitrary<std::uint64_t>()));
    } catch (const Error& refused) {
      RC_ASSERT(std::string(refused.what()).find("overlaps") != std::string::npos);
    }
  }
}

RC_GTEST_PROP(ScheduleProperty, ResolvedListReadsBackUnchanged, ()) {
  const Schedule schedule = random_schedule();
  const FaultContext context = small_context();
  const std::string yaml = schedule_yaml(schedule, context.clock);
  RC_ASSERT(read_text(yaml) == schedule);
  RC_ASSERT(schedule_yaml(read_text(yaml), context.clock) == yaml);
}

RC_GTEST_PROP(ScheduleProperty, SeedDecidesTheDraws, (std::uint64_t seed)) {
  const auto text = [](std::uint64_t s) {
    return "schema: 1\nseed: " + std::to_string(s) +
           "\nfaults: [{name: a, type: demand.scale, target: {pick: 2}, start: {uniform: {min: \"06:00\", max: "
           "\"20:00\"}}, duration: {lognormal: {median: 40min, sigma: 0.6}}, magnitude: {normal: {mean: 2, sd: "
           "0.1}}}]\n";
  };
  RC_ASSERT(read_text(text(seed)) == read_text(text(seed)));
  RC_ASSERT(read_text(text(seed)).faults != read_text(text(seed + 1)).faults);
}

RC_GTEST_PROP(ScheduleProperty, FaultsAreWithinTheDayAndTheCity, ()) {
  const FaultContext context = small_context();
  for (const auto& fault : random_schedule().faults) {
    const FaultType& type = fault_type(fault.type);
    RC_ASSERT(fault.start >= 0 && fault.start < context.clock.minutes());
    RC_ASSERT(fault.duration >= 1);
    RC_ASSERT(fault.ramp >= 0 && 2 * fault.ramp <= fault.duration);
    RC_ASSERT(!fault.regions.empty() && std::is_sorted(fault.regions.begin(), fault.regions.end()));
    RC_ASSERT(fault.magnitudes.size() == fault.regions.size());
    for (std::size_t i = 0; i < fault.regions.size(); ++i) {
      const bool points = type.counts_points();
      RC_ASSERT(fault.magnitudes[i] >= (points ? 1.0 : type.range.low));
      RC_ASSERT(fault.magnitudes[i] <= (points ? context.points_per_region.at(fault.regions[i]) : type.range.high));
    }
  }
}

RC_GTEST_PROP(ScheduleProperty, EveryFaultActsInItsWindowOnly, ()) {
  const FaultContext context = small_context();
  const Schedule schedule = random_schedule();
  std::vector<int> acted(schedule.faults.size());
  for (int tick = 0; tick < context.clock.ticks(); ++tick) {
    for (const auto& effect : faults_at(schedule, context.clock, tick).effects) {
      const Fault& fault = schedule.faults.at(effect.fault);
      const double full = fault.magnitudes.at(std::find(fault.regions.begin(), fault.regions.end(), effect.region) -
                                              fault.regions.begin());
      const TickWindow window = tick_window(fault, context.clock);
      RC_ASSERT(window.holds(tick));
      const double neutral = fault_type(fault.type).neutral;
      const bool absence = effect.type == EffectType::process_kill || effect.type == EffectType::process_pause ||
                           effect.type == EffectType::host_down;
      RC_ASSERT(effect.magnitude >= (absence ? window.last - tick : std::min(neutral, full)));
      RC_ASSERT(effect.magnitude <= (absence ? window.last - tick : std::max(neutral, full)));
      ++acted[effect.fault];
    }
  }
  for (const int ticks : acted) {
    RC_ASSERT(ticks > 0);
  }
}

}  // namespace
}  // namespace evbal
