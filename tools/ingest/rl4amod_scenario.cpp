#include "tools/ingest/rl4amod_scenario.hpp"

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "tools/ingest/raw_json.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <string>

namespace evbal {
namespace {

using nlohmann::json;

constexpr int kMostRegions = 1000;
constexpr double kMostAMinute = 1e4;  // of a pair in a minute

/// A member of the file that says where it stands if it is wrong.
class Place {
 public:
  Place(const json& value, std::string file, std::string name)
      : value_(value), file_(std::move(file)), name_(std::move(name)) {}

  Place operator[](const char* key) const {
    return {member(value_, key), file_, name_.empty() ? key : name_ + "." + key};
  }

  /// The items of a list that is not empty.
  std::vector<Place> items() const {
    if (!value_.is_array() || value_.empty()) {
      throw error("a list is expected, with an entry at least");
    }
    std::vector<Place> places;
    for (std::size_t i = 0; i < value_.size(); ++i) {
      places.emplace_back(value_[i], file_, name_ + "[" + std::to_string(i) + "]");
    }
    return places;
  }

  double number(double low, double high) const {
    const auto number = value_.is_number() ? std::optional(value_.get<double>()) : std::nullopt;
    if (!number || !(*number >= low && *number <= high)) {
      throw error("a number from " + decimal(low) + " to " + decimal(high) + " is expected, not `" + value_.dump() +
                  "`");
    }
    return *number;
  }

  int integer(int low, int high) const {
    const double value = number(low, high);
    if (value != std::floor(value)) {
      throw error("a whole number is expected, not `" + value_.dump() + "`");
    }
    return static_cast<int>(value);
  }

  Error error(const std::string& message) const { return bad_input(file_, 0, name_ + ": " + message); }

 private:
  const json& value_;
  std::string file_;
  std::string name_;
};

void read_fleet_hours(const Place& list, Rl4amodScenario& scenario) {
  for (const Place& entry : list.items()) {
    const int hour = entry["hour"].integer(0, 23);
    if (scenario.fleet.empty()) {
      scenario.first_hour = hour;
    } else if (hour != scenario.first_hour + scenario.hours) {
      throw entry.error("hours are expected one after another, next " +
                        std::to_string(scenario.first_hour + scenario.hours));
    }
    ++scenario.hours;
    scenario.fleet.push_back(entry["acc"].integer(0, 1'000'000));
  }
}

void read_trips(const Place& list, Rl4amodScenario& scenario) {
  const int first = 60 * scenario.first_hour;
  const int last = first + 60 * scenario.hours - 1;
  for (const Place& entry : list.items()) {
    PricedTrips trips;
    trips.minute = entry["time_stamp"].integer(first, last);
    trips.origin = entry["origin"].integer(0, scenario.regions - 1);
    trips.destination = entry["destination"].integer(0, scenario.regions - 1);
    trips.trips = entry["demand"].number(0.0, kMostAMinute);
    trips.minutes = entry["travel_time"].number(0.0, 24.0 * 60.0);
    trips.price = entry["price"].number(0.0, 1e6);
    scenario.trips.push_back(trips);
  }
}

void read_empty_minutes(const Place& list, Rl4amodScenario& scenario) {
  const int n = scenario.regions;
  scenario.empty_minutes = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXi hours = Eigen::MatrixXi::Zero(n, n);
  for (const Place& entry : list.items()) {
    const int from = entry["origin"].integer(0, n - 1);
    const int to = entry["destination"].integer(0, n - 1);
    scenario.empty_minutes(from, to) += entry["reb_time"].number(0.0, 24.0 * 60.0);
    ++hours(from, to);
  }
  for (int from = 0; from < n; ++from) {
    for (int to = 0; to < n; ++to) {
      if (hours(from, to) == 0) {
        throw list.error("has no entry from region " + std::to_string(from) + " to " + std::to_string(to) +
                         "; every pair needs one");
      }
      scenario.empty_minutes(from, to) /= hours(from, to);
    }
  }
}

}  // namespace

Rl4amodScenario read_rl4amod(const std::filesystem::path& file) {
  const json whole = read_raw_json(file, "scenario of RL4AMOD", "object");
  const Place top(whole, file.string(), "");
  Rl4amodScenario scenario;
  scenario.regions = top["nlat"].integer(1, kMostRegions);
  scenario.regions *= top["nlon"].integer(1, kMostRegions / scenario.regions);
  read_fleet_hours(top["totalAcc"], scenario);
  read_trips(top["demand"], scenario);
  read_empty_minutes(top["rebTime"], scenario);
  return scenario;
}

}  // namespace evbal
