#pragma once

#include "experiments/search/worst_search.hpp"
#include "tests/faults/schedule_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace evbal::testing {

inline const std::string three_entries =
    "  - {name: outage, type: charger.outage, target: {pick: {uniform: {min: 1, max: 2}}},\n"
    "     arrivals: {poisson: {per_hour: 0.3, from: \"07:00\", to: \"20:00\"}},\n"
    "     duration: {uniform: {min: 10min, max: 2h}}, magnitude: {fraction_of_points: {uniform: {min: 0.2, max: 1}}}}\n"
    "  - {name: spike, type: demand.scale, target: {pick: 2}, start: {uniform: {min: \"06:00\", max: \"23:50\"}},\n"
    "     duration: {lognormal: {median: 40min, sigma: 0.5}}, ramp: 10min,\n"
    "     magnitude: {normal: {mean: 1.8, sd: 0.2, min: 1}}}\n"
    "  - {name: jam, type: travel.slow, target: {regions: [2]}, arrivals: {poisson: {per_hour: 0.1}}, duration: "
    "30min,\n"
    "     magnitude: 2}\n";

inline Ingredients ingredients_of(const std::string& faults, const std::string& head) {
  YamlMap map(YamlValue::parse("schema: 1\n" + head + "faults:\n" + faults, "faults.yaml"));
  Ingredients ingredients = read_ingredients(map, small_context());
  map.finish();
  return ingredients;
}

/// Three entries under a guard that binds.
inline Ingredients small_ingredients(std::uint64_t seed) {
  return ingredients_of(three_entries,
                        "seed: " + std::to_string(seed) + "\nguard: {max_active: 3, min_working_points: 12}\n");
}

/// A harm that was made up: points that fail hurt by their minutes, most in region 3 and around noon; a spike hurts a
/// little; a jam does not.
inline double made_up_harm(const Picks& picks) {
  double harm = 0.0;
  for (const auto& [entry, fault] : picks) {
    for (std::size_t i = 0; i < fault.regions.size(); ++i) {
      const double noon = 7 * 60.0;  // minutes after 05:00
      const double near = std::exp(-std::abs(fault.start + 0.5 * fault.duration - noon) / 120.0);
      const double of_entry = entry == 0 ? (fault.regions[i] == 3 ? 3.0 : 0.2) : entry == 1 ? 0.5 : 0.0;
      harm += of_entry * fault.magnitudes[i] * fault.duration * (0.1 + near);
    }
  }
  return harm;
}

/// The harm of each trial, by that of its schedule.
inline Harms harms_by(std::function<double(const Picks&)> harm) {
  return [harm = std::move(harm)](const std::vector<Trial>& trials) {
    std::vector<double> harms;
    for (const auto& trial : trials) {
      harms.push_back(harm(trial.picks));
    }
    return harms;
  };
}

inline std::vector<double> made_up_harms(const std::vector<Trial>& trials) {
  return harms_by(made_up_harm)(trials);
}

}  // namespace evbal::testing
