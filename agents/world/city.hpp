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
  double lat = 0.0;  ///< degrees
  double lon = 0.0;  ///< degrees
};

/// A region of a city.
struct Region {
  std::string name;                          ///< that no other region has
  std::vector<std::vector<LatLon>> outline;  ///< outer rings, each closed implicitly (first point not repeated)
  LatLon centroid;                           ///< mean of trip ends, or centre of area
};

/// A charging station; several may stand in one region, whose points then add up.
struct Station {
  std::string name;  ///< that no other station has
  int region = 0;    ///< where it stands
  int points = 0;    ///< charging points
  LatLon place;      ///< of the station
};

/// Trips of one origin-destination pair that start within one step.
struct TripCount {
  /// More than this of one pair in one step is no count of trips.
  static constexpr int most = 1'000'000;

  int origin = 0;       ///< region
  int destination = 0;  ///< region
  int trips = 0;        ///< number
};

/// Demand of one recorded day: for each step of `City::step_minutes` the pairs with trips, by (origin, destination).
struct DemandDay {
  std::string date;                           ///< ISO 8601, "2008-06-03"
  bool holiday = false;                       ///< a public holiday: a day like a Sunday
  std::vector<std::vector<TripCount>> steps;  ///< by step of the day
};

/// Where the vehicles stand at the day's start.
enum class FleetPlacement {
  pick_ups,  ///< drawn, each region as likely as its share of the day's pick-ups
  even,      ///< as many in each region
};

/// Vehicles, points, batteries and patience that the records do not tell: declared per pack, overridden by scenarios.
struct FleetAssumption {
  int vehicles = 0;                                     ///< of the fleet
  double battery_kwh = 0.0;                             ///< of each vehicle
  double km_per_kwh = 0.0;                              ///< of each vehicle
  double initial_charge_low = 0.0;                      ///< share of the battery at the day's start, drawn uniformly
  double initial_charge_high = 0.0;                     ///< likewise
  FleetPlacement placement = FleetPlacement::pick_ups;  ///< at the day's start
};

/// Chargers and sessions that the records do not tell.
struct ChargingAssumption {
  double power_kw = 0.0;  ///< of each point
  /// Quantiles of a session's minutes at equally spaced probabilities 0, 1/(n-1), ..., 1; at least two, ascending.
  std::vector<double> session_quantiles;
  bool top_up = false;  ///< whether vacant vehicles may be told to charge where they stand; a scenario's, not a pack's
};

/// Passengers' patience, which the records do not tell.
struct PassengerAssumption {
  double patience_low = 0.0;   ///< minutes, drawn uniformly
  double patience_high = 0.0;  ///< minutes
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
  double start_minutes = 0.0;     ///< of each trip
  double minutes_per_km = 0.0;    ///< driven
  std::vector<double> spread_km;  ///< by region
};

/// A city as read from a pack. Matrices are N x N, row = from, column = to; the diagonal is a trip within the region.
struct City {
  std::string name;               ///< of the pack
  std::filesystem::path folder;   ///< of the pack; empty if it was not read from one
  std::string source;             ///< what to cite
  int day_start = 0;              ///< minute after midnight at which each DemandDay starts
  int step_minutes = 30;          ///< of the demand
  std::vector<Region> regions;    ///< in the order by which they are numbered
  std::vector<Station> stations;  ///< by region
  Eigen::MatrixXd km;             ///< mean driven distance, > 0 for every pair
  Eigen::MatrixXd minutes;        ///< mean driving time, >= 1 for every pair
  std::vector<std::string> days;  ///< ISO dates on record, ascending
  /// ISO 8601 dates that settings and models may be fitted on.
  std::vector<std::string> train_days;
  std::vector<std::string> test_days;  ///< every day is for training or for testing
  std::vector<std::string> holidays;   ///< those of `days` that are public holidays
  FleetAssumption fleet;               ///< vehicles
  ChargingAssumption charging;         ///< chargers and sessions
  PassengerAssumption passengers;      ///< patience
  std::optional<CityFactors> factors;  ///< where the pack has no tables

  /// Number of regions.
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
