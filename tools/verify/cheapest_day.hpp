#pragma once

#include "experiments/bound/bound_day.hpp"

#include <cstdint>

namespace evbal {

/// A day that is small enough for cheapest_day: two regions, one or two cars, up to five passengers, less than an hour.
/// Equal seeds give equal days.
BoundDay tiny_day(std::uint64_t seed);

/// The least price x lost + km of a day, by trying everything that can be done with its cars minute by minute, in the
/// order in which a region lives a minute (RegionPlant): cars that stand in a region at a tick's start may be sent off,
/// then cars arrive, then passengers are taken or not.
double cheapest_day(const BoundDay& day, double price);

}  // namespace evbal
