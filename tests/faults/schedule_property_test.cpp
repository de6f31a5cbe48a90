#include "faults/schedule/fault_types.hpp"
#include "tests/faults/schedule_fixture.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

namespace evbal {
namespace {

using testing::read_text;
using testing::small_place;

std::string one_of(std::vector<std::string> texts) {
  return *rc::gen::elementOf(std::move(texts));
}

/// A fault whose every field may be a value or a distribution. Short and rare, so that the guard mostly holds.
std::string random_fault(int index) {
  const bool outage = *rc::gen::arbitrary<bool>();
  std::string text = "  - {name: f" + std::to_string(index) + ", type: " + (outage ? "charger.outage" : "demand.scale");
  text += ", target: " + one_of({"{pick: 1}", "{regions: [3]}", "{regions: [4, 1]}", "{pick: 2, of: {min_points: 5}}"});
  text += ", " + one_of({"start: \"06:10\"", "start: {uniform: {min: \"06:00\", max: \"23:59\"}}",
                         "start: {normal: {mean: \"12:00\", sd: 4h}}", "arrivals: {poisson: {per_hour: 0.1}}"});
  text += ", duration: " +
          one_of({"7min", "2h", "{exponential: {mean: 20min}}", "{lognormal: {median: 40min, sigma: 0.6, max: 3h}}"});
  if (outage) {
    text += ", magnitude: " + one_of({"{fraction_of_points: 0.3}", "{points: {uniform: {min: 1, max: 4}}}"});
    text += one_of({"", ", on_start: evict", ", on_start: drain"});
  } else {
    text += ", magnitude: " + one_of({"1.8", "{normal: {mean: 1.8, sd: 0.7, min: 0.5}}", "{exponential: {mean: 1.5}}"});
    text += one_of({"", ", ramp: 3min", ", ramp: {uniform: {min: 0min, max: 30min}}"});
  }
  return text + one_of({"", ", visible: false"}) + "}\n";
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
  const Place place = small_place();
  const std::string yaml = schedule_yaml(schedule, place.clock);
  RC_ASSERT(read_text(yaml) == schedule);
  RC_ASSERT(schedule_yaml(read_text(yaml), place.clock) == yaml);
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
  const Place place = small_place();
  for (const auto& fault : random_schedule().faults) {
    const bool outage = fault.type == EffectType::charger_outage;
    RC_ASSERT(fault.start >= 0 && fault.start < place.clock.minutes());
    RC_ASSERT(fault.duration >= 1);
    RC_ASSERT(fault.ramp >= 0 && 2 * fault.ramp <= fault.duration);
    RC_ASSERT(std::is_sorted(fault.regions.begin(), fault.regions.end()));
    RC_ASSERT(fault.magnitudes.size() == fault.regions.size());
    for (std::size_t i = 0; i < fault.regions.size(); ++i) {
      const double points = place.points_per_region.at(fault.regions[i]);
      RC_ASSERT(fault.magnitudes[i] >= (outage ? 1.0 : 0.0));
      RC_ASSERT(fault.magnitudes[i] <= (outage ? points : max_factor));
    }
  }
}

RC_GTEST_PROP(ScheduleProperty, EveryFaultActsInItsWindowOnly, ()) {
  const Place place = small_place();
  const Schedule schedule = random_schedule();
  std::vector<int> acted(schedule.faults.size());
  for (int tick = 0; tick < place.clock.ticks(); ++tick) {
    for (const auto& effect : faults_at(schedule, place.clock, tick).effects) {
      const Fault& fault = schedule.faults.at(effect.fault);
      const double full = fault.magnitudes.at(std::find(fault.regions.begin(), fault.regions.end(), effect.region) -
                                              fault.regions.begin());
      RC_ASSERT(tick_window(fault, place.clock).holds(tick));
      RC_ASSERT(effect.magnitude >= std::min(1.0, full));
      RC_ASSERT(effect.magnitude <= std::max(1.0, full));
      ++acted[effect.fault];
    }
  }
  for (const int ticks : acted) {
    RC_ASSERT(ticks > 0);
  }
}

}  // namespace
}  // namespace evbal
