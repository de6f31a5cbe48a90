#include "tools/ingest/ingest_rl4amod.hpp"

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "common/random.hpp"
#include "common/table_text.hpp"
#include "tools/ingest/regions_by_distance.hpp"
#include "tools/ingest/rl4amod_notes.hpp"
#include "tools/ingest/rl4amod_scenario.hpp"
#include "tools/ingest/rounding.hpp"
#include "tools/ingest/stations.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

namespace evbal {
namespace {

/// Trips of a pair in a step, and sums over them.
struct StepTrips {
  double trips = 0.0;    ///< mean number
  double minutes = 0.0;  ///< sum
  double price = 0.0;    ///< sum
};

/// By (step, origin, destination).
using TripsOfSteps = std::map<std::tuple<int, int, int>, StepTrips>;

TripsOfSteps trips_of_steps(const Rl4amodScenario& scenario, const City& city, double ratio) {
  TripsOfSteps steps;
  for (const PricedTrips& entry : scenario.trips) {
    const double trips = ratio * entry.trips;
    if (trips > 0.0) {
      StepTrips& sum = steps[{(entry.minute - city.day_start) / city.step_minutes, entry.origin, entry.destination}];
      sum.trips += trips;
      sum.minutes += trips * entry.minutes;
      sum.price += trips * entry.price;
    }
  }
  return steps;
}

/// Passengers' minutes where there are any, else those of cars without.
Eigen::MatrixXd minutes_of(const Rl4amodScenario& scenario, const TripsOfSteps& steps) {
  Eigen::MatrixXd trips = Eigen::MatrixXd::Zero(scenario.regions, scenario.regions);
  Eigen::MatrixXd sum = trips;
  for (const auto& [at, step] : steps) {
    trips(std::get<1>(at), std::get<2>(at)) += step.trips;
    sum(std::get<1>(at), std::get<2>(at)) += step.minutes;
  }
  const Eigen::MatrixXd minutes = (trips.array() > 0.0).select(sum.cwiseQuotient(trips), scenario.empty_minutes);
  return minutes.unaryExpr([](double value) { return std::max(1.0, rounded(value, 10.0)); });
}

DemandDay draw_day(const City& city, const TripsOfSteps& steps, std::uint64_t seed, std::size_t number) {
  const std::string& date = city.days[number];
  DemandDay day{date, std::binary_search(city.holidays.begin(), city.holidays.end(), date), {}};
  day.steps.resize(city.steps_per_day());
  for (const auto& [at, step] : steps) {
    const auto [index, origin, destination] = at;
    RandomStream stream(seed, Purpose::ingested_day,
                        {.region = static_cast<std::uint64_t>(origin),
                         .tick = number * day.steps.size() + static_cast<std::uint64_t>(index),
                         .index = static_cast<std::uint64_t>(destination)});
    if (const auto trips = static_cast<int>(stream.poisson(step.trips)); trips > 0) {
      day.steps[index].push_back({origin, destination, trips});
    }
  }
  return day;
}

void add_stations(City& city, const TripsOfSteps& steps, const Rl4amodNotes& notes) {
  Eigen::VectorXd ends = Eigen::VectorXd::Zero(city.size());
  for (const auto& [at, step] : steps) {
    ends[std::get<1>(at)] += step.trips;
    ends[std::get<2>(at)] += step.trips;
  }
  for (const auto& choice : choose_stations(city.km, ends, notes.stations, notes.points)) {
    const Region& region = city.regions[choice.region];
    city.stations.push_back({"s-" + region.name, choice.region, choice.points, region.centroid});
  }
}

std::string prices_csv(const TripsOfSteps& steps) {
  std::string text = "step,origin,destination,price,minutes\n";
  for (const auto& [at, step] : steps) {
    text +=
        csv_row({decimal(std::get<0>(at)), decimal(std::get<1>(at)), decimal(std::get<2>(at)),
                 decimal(rounded(step.price / step.trips, 100.0)), decimal(rounded(step.minutes / step.trips, 10.0))});
  }
  return text;
}

std::string report_of(const Rl4amodScenario& scenario, const IngestedCity& made, const TripsOfSteps& steps) {
  double trips = 0.0;
  for (const auto& [at, step] : steps) {
    trips += step.trips;
  }
  std::ostringstream out;
  out << "regions: " << scenario.regions << "\nhours: " << scenario.first_hour << ":00 to "
      << scenario.first_hour + scenario.hours << ":00\ncars by hour:";
  for (const int cars : scenario.fleet) {
    out << " " << cars;
  }
  out << ", of the pack: " << made.city.fleet.vehicles << "\nentries of demand: " << scenario.trips.size()
      << "\ntrips a day, mean: " << std::lround(trips) << "\ndays drawn: " << made.days.size()
      << "\nstations: " << made.city.stations.size() << ", points: " << made.city.points().sum() << "\n";
  return out.str();
}

}  // namespace

Rl4amodCity ingest_rl4amod(const std::filesystem::path& scenario_file, const std::filesystem::path& notes_file) {
  const Rl4amodScenario scenario = read_rl4amod(scenario_file);
  Rl4amodNotes notes = read_rl4amod_notes(notes_file);
  if (notes.stations > scenario.regions) {
    throw bad_input(notes_file.string(), 0, "more stations than regions; give at most one a region");
  }
  Rl4amodCity result{{std::move(notes.city), {}, {}}, {}};
  City& city = result.made.city;
  city.day_start = 60 * scenario.first_hour;
  const TripsOfSteps steps = trips_of_steps(scenario, city, notes.demand_ratio);
  city.minutes = minutes_of(scenario, steps);
  city.km = (notes.kmh / 60.0 * city.minutes).unaryExpr([](double km) { return rounded(km, 100.0); });
  city.regions = regions_by_distance(city.km);
  add_stations(city, steps, notes);
  for (std::size_t number = 0; number < city.days.size(); ++number) {
    result.made.days.push_back(draw_day(city, steps, notes.seed, number));
  }
  result.prices = prices_csv(steps);
  result.made.report = report_of(scenario, result.made, steps);
  return result;
}

}  // namespace evbal
