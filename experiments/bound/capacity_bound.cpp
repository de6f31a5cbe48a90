#include "experiments/bound/capacity_bound.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace evbal {
namespace {

int overlap(int start, int end, int from, int until) {
  return std::max(0, std::min(end, until) - std::max(start, from));
}

/// Those of whom something falls into the window whatever happens, less those whom the cars have minutes for.
int lost_in(const BoundDay& day, std::int64_t cars, int start, int end) {
  std::vector<int> least;
  for (const BoundPassenger& one : day.passengers) {
    const int minutes = day.minutes(one.origin, one.destination);
    // The overlap first grows and then falls with the minute of departure: least at one of the ends.
    const int needed = std::min(overlap(start, end, one.appears, one.appears + minutes),
                                overlap(start, end, one.last, one.last + minutes));
    if (needed > 0) {
      least.push_back(needed);
    }
  }
  std::sort(least.begin(), least.end());
  std::int64_t left = cars * (end - start);
  const auto unserved = std::find_if(least.begin(), least.end(), [&](int needed) {
    left -= needed;
    return left < 0;
  });
  return static_cast<int>(least.end() - unserved);
}

}  // namespace

CapacityBound capacity_bound(const BoundDay& day) {
  const auto cars = std::accumulate(day.cars.begin(), day.cars.end(), std::int64_t{0});
  const int minutes = day.ticks * day.tick;
  CapacityBound tightest;
  for (int start = 0; start < minutes; start += day.step) {
    for (int end = start + day.step; end <= minutes; end += day.step) {
      const int lost = lost_in(day, cars, start, end);
      if (lost > tightest.lost) {
        tightest = {lost, start, end};
      }
    }
  }
  return tightest;
}

}  // namespace evbal
