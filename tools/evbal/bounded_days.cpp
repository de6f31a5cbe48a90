#include "tools/evbal/bounded_days.hpp"

#include "common/error.hpp"
#include "experiments/bound/bound_file.hpp"
#include "experiments/study/store/sweep_origin.hpp"
#include "tools/evbal/runs_folder.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace evbal {
namespace {

/// What of a variant's settings may change the bound: all but prices.
std::map<std::string, std::string> of_the_world(const FinishedDay& day) {
  std::map<std::string, std::string> settings = day.settings;
  std::erase_if(settings,
                [](const auto& setting) { return setting.first.starts_with("balancing.") || setting.second.empty(); });
  return settings;
}

/// The days of a sweep by what bounds them.
class BoundKeys {
 public:
  explicit BoundKeys(YamlValue scenario) : scenario_(std::move(scenario)) {}

  /// The key of a day's bound. Throws Error{bad_input} if another variant has another one on the same day and seed.
  const std::string& of(const FinishedDay& day) {
    const auto [at, is_new] = keys_.emplace(std::tuple(day.day, day.seed, of_the_world(day)), "");
    if (is_new) {
      Overrides overrides;
      overrides.day = day.day;
      overrides.seed = day.seed;
      for (const auto& [path, value] : std::get<2>(at->first)) {
        overrides.settings.push_back(path);
        overrides.settings.back().append("=").append(value);
      }
      const Scenario scenario = read_scenario(scenario_, overrides);
      if (!scenario.schedule.faults.empty()) {
        throw bad_input(
            "--against bound: the sweep's first days have faults, which are drawn anew for each seed; "
            "bounds are compared with days without");
      }
      at->second = bound_key(scenario);
      const std::string& first = first_.emplace(std::pair(day.day, day.seed), at->second).first->second;
      if (first != at->second) {
        throw bad_input("variant `" + day.variant + "` plays another day than others on " + day.day +
                        ": no one bound holds for all of them");
      }
    }
    return at->second;
  }

 private:
  YamlValue scenario_;
  std::map<std::tuple<std::string, std::uint64_t, std::map<std::string, std::string>>, std::string> keys_;
  std::map<std::pair<std::string, std::uint64_t>, std::string> first_;
};

}  // namespace

std::vector<FinishedDay> bound_points(const std::vector<Driving>& corners, FinishedDay day) {
  day.variant = bound_variant;
  day.controller = bound_variant;
  std::vector<FinishedDay> points;
  for (const Driving& corner : corners) {
    day.totals = {{"idle_km", corner.km}, {"lost", corner.lost}};
    points.push_back(day);
  }
  return points;
}

std::vector<FinishedDay> bounded_days(const std::filesystem::path& sweep_file, const std::vector<FinishedDay>& days) {
  BoundKeys keys(YamlValue::parse(read_origin(sweep_file).scenario, sweep_file.string()));
  std::set<std::string> seen;
  std::vector<FinishedDay> bounded;
  for (const FinishedDay& day : days) {
    if (day.scenario != days.front().scenario || day.faults != days.front().faults) {
      continue;
    }
    const std::string& key = keys.of(day);
    const auto bound = seen.insert(key).second ? read_bound(bound_file(bounds_folder(), key)) : std::nullopt;
    if (bound) {
      const auto points = bound_points(bound_corners(*bound), day);
      bounded.insert(bounded.end(), points.begin(), points.end());
    }
  }
  if (bounded.empty()) {
    throw bad_input("no bound is kept in " + bounds_folder().string() +
                    " for any day of the sweep; compute them with `evbal bound`, day by day and seed by seed");
  }
  return bounded;
}

}  // namespace evbal
