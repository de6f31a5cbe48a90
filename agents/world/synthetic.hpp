#pragma once

#include "agents/world/city.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace evbal {

/// What a generated city shall be like.
struct SyntheticOptions {
  std::string name = "toy-5";     ///< of the city
  int regions = 5;                ///< >= 1, about 3 km wide each
  int train_days = 10;            ///< from Monday 2024-01-01 on; at least one day in all
  int test_days = 2;              ///< follow the training days
  std::uint64_t seed = 1;         ///< of all that is drawn
  double trips_per_day = 2100.0;  ///< mean over days
  int vehicles = 60;              ///< of the fleet
  double battery_kwh = 20.0;      ///< of each vehicle
  int stations = 2;               ///< 0 .. regions, each in a region of its own
  int points = 4;                 ///< of all stations, >= stations
};

/// A city that was generated.
struct SyntheticCity {
  City city;                    ///< without the demand of its days
  std::vector<DemandDay> days;  ///< the demand, by day
};

/// A city on a jittered grid. Trips lead from home to work regions in the morning and back in the evening, fewer to
/// far regions; days and regions vary log-normally, counts are Poisson. Equal options give an equal city. `folder` is
/// left empty: write_city saves the city, and it can be used without.
SyntheticCity synthetic_city(const SyntheticOptions& options);

}  // namespace evbal
