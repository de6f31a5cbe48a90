#pragma once

#include "common/eigen.hpp"

#include <filesystem>
#include <vector>

namespace evbal {

/// Trips between two regions that are asked for in one minute.
struct PricedTrips {
  int minute = 0;        ///< of the day
  int origin = 0;        ///< region
  int destination = 0;   ///< region
  double trips = 0.0;    ///< mean number
  double minutes = 0.0;  ///< of driving
  double price = 0.0;    ///< that each passenger pays
};

/// A scenario of RL4AMOD's macroscopic simulator.
struct Rl4amodScenario {
  int regions = 0;                 ///< nlat x nlon
  int first_hour = 0;              ///< of those that have a fleet
  int hours = 0;                   ///< that have a fleet, one after another
  std::vector<int> fleet;          ///< cars, by hour
  std::vector<PricedTrips> trips;  ///< in the order of the file, all within these hours
  Eigen::MatrixXd empty_minutes;   ///< from and to: driving time without passengers, mean over the hours
};

/// Reads a `scenario_CITY.json`, plain or compressed. Throws Error{bad_input} with file and, of what is no JSON, line;
/// of a wrong entry its place, such as `demand[3].origin`, and what would be right.
Rl4amodScenario read_rl4amod(const std::filesystem::path& file);

}  // namespace evbal
