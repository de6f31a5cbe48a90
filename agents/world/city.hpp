#pragma once

#include "common/eigen.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// WGS84 degrees.
struct LatLon {
  double lat = 0.0;
  double lon = 0.0;
};

struct Region {
  std::string name;
  std::vector<std::vector<LatLon>> outline;  ///< outer rings, each closed implicitly (first point not repeated)
  LatLon centroid;
};

/// A charging station; several may stand in one region, whose points then add up.
struct Station {
  std::string name;
  int region = 0;
  int points = 0;
  LatLon place;
};

/// Trips of one origin-destination pair that start within one step.
struct TripCount {
  int origin = 0;
  int destination = 0;
  int trips = 0;
};

/// Demand of one recorded day: for each step of `City::step_minutes` the pairs with trips, by (origin, destination).
struct DemandDay {
  std::string date;      ///< ISO 8601, "2008-06-03"
  bool holiday = false;  ///< a public holiday: a day like a Sunday
  std::vector<std::vector<TripCount>> steps;
};

/// Vehicles, points, batteries and patience that the records do not tell: declared per pack, overridden by scenarios.
struct FleetAssumption {
  int vehicles = 0;
  double battery_kwh = 0.0;
  double km_per_kwh = 0.0;
  double initial_charge_low = 0.0;  ///< share of the battery at the day's start, drawn uniformly
  double initial_charge_high = 0.0;
};

struct ChargingAssumption {
  double power_kw = 0.0;
  /// Quantiles of a session's minutes at equally spaced probabilities 0, 1/(n-1), ..., 1; at least two, ascending.
  std::vector<double> session_quantiles;
};

struct PassengerAssumption {
  double patience_low = 0.0;  ///< minutes, drawn uniformly
  double patience_high = 0.0;
};

/// What stands in for records that a city lacks: demand and travel as factors, which a pack keeps in place of a table
/// of every day and of every pair.
struct CityFactors {
  /// Demand of a pair in a step of a day is a Poisson draw around pairs x share x course(day, step) x the origin's
  /// deviation on that day, which is log-normal with mean 1.
  std::vector<TripCount> pairs;   ///< trips of a whole day on record, by (origin, destination)
  double share = 1.0;             ///< of these trips that the fleet is asked for
  Eigen::MatrixXd course;         ///< days x steps: share of a mean day's trips that start then
  double region_deviation = 0.0;  ///< standard deviation of a region's pick-ups on a day, relative
  std::uint64_t seed = 1;         ///< of the draws

  /// km = detour * sqrt(D^2 + s_from^2 + s_to^2), the root mean square distance of two random places, with D between
  /// the centroids and s the spread around each; minutes = start_minutes + minutes_per_km * km.
  double detour = 1.0;
  double start_minutes = 0.0;
  double minutes_per_km = 0.0;
  std::vector<double> spread_km;  ///< by region
};

/// A city as read from a pack. Matrices are N x N, row = from, column = to; the diagonal is a trip within the region.
struct City {
  std::string name;
  std::filesystem::path folder;
  std::string source;  ///< what to cite
  int day_start = 0;   ///< minute after midnight at which each DemandDay starts
  int step_minutes = 30;
  std::vector<Region> regions;
  std::vector<Station> stations;
  Eigen::MatrixXd km;             ///< mean driven distance, > 0 for every pair
  Eigen::MatrixXd minutes;        ///< mean driving time, >= 1 for every pair
  std::vector<std::string> days;  ///< ISO dates on record, ascending
  std::vector<std::string> train_days;
  std::vector<std::string> test_days;  ///< every day is for training or for testing
  std::vector<std::string> holidays;   ///< those of `days` that are public holidays
  FleetAssumption fleet;
  ChargingAssumption charging;
  PassengerAssumption passengers;
  std::optional<CityFactors> factors;  ///< where the pack has no tables

  int size() const { return static_cast<int>(regions.size()); }

  /// Steps of a DemandDay, which lasts until midnight.
  int steps_per_day() const { return (24 * 60 - day_start) / step_minutes; }

  /// Charging points of each region, N.
  Eigen::VectorXi points() const;

  /// For each region the region with a station that is nearest by km (itself if it has one), -1 if there is none.
  std::vector<int> nearest_station() const;
};

/// Reads a city pack (docs/city-packs.md). Throws Error{bad_input} with file, line and reason.
City read_city(const std::filesystem::path& folder);

/// Reads one day of demand, or draws it from the city's factors. Throws Error{bad_input} if the day is not on record
/// (naming those that are) or malformed.
DemandDay read_demand(const City& city, const std::string& date);

/// Writes a pack that read_city and read_demand give back; `days` are those of `city.days`, in that order, or none for
/// a city of factors. Throws Error{bad_input} if the folder exists and is not empty, Error{run_failed} if the pack
/// cannot be written, of which nothing is left behind then.
void write_city(const City& city, const std::vector<DemandDay>& days, const std::filesystem::path& folder);

}  // namespace evbal
