#include "tools/evbal/part_bounds.hpp"

#include "common/installation.hpp"
#include "common/interrupt.hpp"
#include "tools/evbal/kept_bound.hpp"

#include <algorithm>
#include <cstdio>

namespace evbal {

std::filesystem::path find_benchmark(const std::filesystem::path& given) {
  return find_shipped("benchmarks", given);
}

StudiedBound bound_of(const BenchmarkPart& part, const SweptDay& day) {
  DayBound bound = kept_bound(scenario_of(day), part.bound.prices, [](const BoundProgress&) {
    check_interrupt();
    return false;
  });
  std::erase_if(bound.points, [&](const BoundPoint& point) {
    return std::find(part.bound.prices.begin(), part.bound.prices.end(), point.price) == part.bound.prices.end();
  });
  return {day.day, day.seed, bound_corners(bound)};
}

std::vector<StudiedBound> bounds_of(const BenchmarkPart& part, const Sweep& sweep, bool quiet) {
  std::vector<StudiedBound> bounds;
  for (const std::size_t position : days_to_bound(sweep, part.bound)) {
    const SweptDay& day = sweep.days[position];
    if (!quiet) {
      std::fprintf(stderr, "bound of %s, %s seed %llu\n", part.name.c_str(), day.day.c_str(),
                   static_cast<unsigned long long>(day.seed));
    }
    bounds.push_back(bound_of(part, day));
  }
  return bounds;
}

}  // namespace evbal
