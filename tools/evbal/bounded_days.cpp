#include "tools/evbal/bounded_days.hpp"

#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "experiments/bound/bound_file.hpp"
#include "experiments/study/statistics/comparison.hpp"
#include "tools/evbal/runs_folder.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

namespace evbal {
namespace {

/// What of a variant's settings may change the bound.
std::map<std::string, std::string> of_the_world(const SweptDay& day) {
  std::map<std::string, std::string> settings = day.settings;
  std::erase_if(settings, [](const auto& setting) {
    const std::string& path = setting.first;
    return path.starts_with("balancing.") || path.starts_with("charging.") || path == "clock.plan_every" ||
           path == "engine";
  });
  return settings;
}

/// A scenario, schedule of faults, day and seed.
using BoundedPlace = std::tuple<std::string, std::string, std::string, std::uint64_t>;

/// The bounds that are kept, by where they hold.
std::map<BoundedPlace, std::vector<Driving>> corners_by_place(const std::vector<BoundKey>& keys) {
  std::map<BoundedPlace, std::vector<Driving>> corners;
  for (const BoundKey& key : keys) {
    const auto bound = key.key.empty() ? std::nullopt : read_bound(bound_file(bounds_folder(), key.key));
    if (bound) {
      corners[{key.scenario, key.faults, key.day, key.seed}] = bound_corners(*bound);
    }
  }
  return corners;
}

std::vector<FinishedDay> points_of(const std::vector<BoundKey>& keys, const std::vector<FinishedDay>& days) {
  auto corners = corners_by_place(keys);
  std::vector<FinishedDay> points;
  for (const FinishedDay& day : days) {
    const auto found = corners.find({day.scenario, day.faults, day.day, day.seed});
    if (found != corners.end()) {
      const auto of_day = bound_points(found->second, day);
      points.insert(points.end(), of_day.begin(), of_day.end());
      corners.erase(found);
    }
  }
  return points;
}

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

std::vector<BoundKey> bound_keys_of(const Sweep& sweep) {
  std::vector<BoundKey> keys;
  std::map<BoundedPlace, std::size_t> positions;
  std::map<std::pair<BoundedPlace, std::map<std::string, std::string>>, std::string> known;
  for (const SweptDay& day : sweep.days) {
    const BoundedPlace place(day.scenario, day.faults, day.day, day.seed);
    const auto [at, is_new] = known.emplace(std::pair(place, of_the_world(day)), "");
    if (!is_new) {
      continue;
    }
    at->second = bound_key(scenario_of(day));
    check_interrupt();
    const auto [position, is_first] = positions.emplace(place, keys.size());
    if (is_first) {
      keys.push_back({day.scenario, day.faults, day.day, day.seed, at->second});
    } else if (keys[position->second].key != at->second) {
      keys[position->second].key.clear();
    }
  }
  return keys;
}

std::vector<FinishedDay> kept_bounds(const std::filesystem::path& sweep_file, const std::vector<FinishedDay>& days) {
  try {
    return points_of(read_bound_keys(sweep_file), days);
  } catch (const Error&) {
    return {};  // why there are none is told to those who ask for them by `evbal compare`
  }
}

std::vector<FinishedDay> bounded_days(const std::filesystem::path& sweep_file, const std::vector<FinishedDay>& days) {
  const auto points = points_of(read_bound_keys(sweep_file), days);
  if (points.empty()) {
    throw bad_input("no bound is kept in " + bounds_folder().string() +
                    " for any day of the sweep, on which all variants play in the same world; compute them with "
                    "`evbal bound`, day by day and seed by seed");
  }
  return points;
}

}  // namespace evbal
