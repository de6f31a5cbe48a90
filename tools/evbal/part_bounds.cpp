#include "tools/evbal/part_bounds.hpp"

#include "common/installation.hpp"
#include "common/interrupt.hpp"
#include "tools/evbal/kept_bound.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

namespace evbal {

std::filesystem::path find_benchmark(const std::filesystem::path& given) {
  return find_shipped("benchmarks", given);
}

StudiedBound bound_of(const BenchmarkPart& part, const SweptDay& day) {
  DayBound bound = kept_bound(scenario_of(day), part.bound_prices, [](const BoundProgress&) {
    check_interrupt();
    return false;
  });
  std::erase_if(bound.points, [&](const BoundPoint& point) {
    return std::find(part.bound_prices.begin(), part.bound_prices.end(), point.price) == part.bound_prices.end();
  });
  return {day.day, day.seed, bound_corners(bound)};
}

std::vector<StudiedBound> bounds_of(const BenchmarkPart& part, const Sweep& sweep, bool quiet) {
  std::vector<StudiedBound> bounds;
  std::set<std::pair<std::string, std::uint64_t>> seen;
  for (const SweptDay& day : sweep.days) {
    const auto& seeds = part.bound_seeds;
    const bool wanted = std::find(seeds.begin(), seeds.end(), day.seed) != seeds.end();
    if (!wanted || seen.contains({day.day, day.seed}) || !scenario_of(day).schedule.faults.empty()) {
      continue;
    }
    seen.emplace(day.day, day.seed);
    if (!quiet) {
      std::fprintf(stderr, "bound of %s, %s seed %llu\n", part.name.c_str(), day.day.c_str(),
                   static_cast<unsigned long long>(day.seed));
    }
    bounds.push_back(bound_of(part, day));
  }
  return bounds;
}

}  // namespace evbal
