#include "tools/ingest/ingest_counts.hpp"

#include "agents/world/factors.hpp"
#include "common/error.hpp"
#include "tools/ingest/count_notes.hpp"
#include "tools/ingest/ingest_partition.hpp"
#include "tools/ingest/rounding.hpp"
#include "tools/ingest/station_list.hpp"
#include "tools/ingest/trip_end_sums.hpp"
#include "tools/ingest/zone_places.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

namespace evbal {
namespace {

constexpr int kLengths = 21;  // quantiles of the sessions
constexpr int kPlaces = 64;   // in a zone, over which its trip ends are spread

/// Pick-ups and drop-offs of each zone.
std::vector<double> ends_of(const ZoneCounts& counts, std::size_t zones) {
  std::vector<double> ends(zones, 0.0);
  for (const ZoneCount& cell : counts.cells) {
    ends[cell.from] += cell.trips;
    ends[cell.to] += cell.trips;
  }
  return ends;
}

/// Sets the regions' centroids to their mean trip end, spread evenly over each zone, and returns the spread around it.
std::vector<double> place_regions(const Partition& partition, const std::vector<double>& ends,
                                  std::vector<Region>& regions) {
  TripEndSums places(regions);
  const ZonePlaces within(partition.zones);
  for (std::size_t z = 0; z < partition.zones.size(); ++z) {
    // A zone without trips counts a little, so that its region has a place and a size.
    const double weight = std::max(ends[z], 1e-6) / kPlaces;
    for (std::uint64_t draw = 0; draw < kPlaces; ++draw) {
      places.add(partition.region_of[z], *within.place(partition.zones[z].name, draw), weight);
    }
  }
  return places.place(regions, 0.0);
}

std::vector<DemandDay> demand_days(const City& city, const ZoneCounts& counts, const std::vector<int>& region_of) {
  std::map<std::tuple<int, int, int, int>, int> trips;  // by day, step, origin and destination
  for (const ZoneCount& cell : counts.cells) {
    trips[{cell.day, cell.step, region_of[cell.from], region_of[cell.to]}] += cell.trips;
  }
  std::vector<DemandDay> days;
  for (const std::string& date : city.days) {
    const bool holiday = std::binary_search(city.holidays.begin(), city.holidays.end(), date);
    days.push_back({date, holiday, {}});
    days.back().steps.resize(city.steps_per_day());
  }
  for (const auto& [key, count] : trips) {
    const auto& [day, step, from, to] = key;
    days[day].steps[step].push_back({from, to, count});
  }
  return days;
}

/// Sets km and minutes of all pairs. The pack has one table for the day: hours count by the trips that start in them.
void set_mean_travel(const TravelSample& travel, const ZoneCounts& counts, std::vector<double> spread_km, City& city) {
  double trips = 0.0;
  double pace = 0.0;
  double detour = 0.0;
  for (const ZoneCount& cell : counts.cells) {
    const HourOfTravel& hour = travel.hours.at((city.day_start + cell.step * city.step_minutes) / 60);
    trips += cell.trips;
    pace += cell.trips * hour.pace;
    detour += cell.trips * hour.detour;
  }
  CityFactors& factors = city.factors.emplace();
  factors.detour = detour / trips;
  factors.start_minutes = travel.law.start * pace / trips;
  factors.minutes_per_km = travel.law.per_km * pace / trips;
  factors.spread_km = std::move(spread_km);
  set_travel(city);
  city.factors.reset();
  city.minutes = city.minutes.unaryExpr([](double minutes) { return rounded(minutes, 10.0); });
}

/// The distance by which the detour is measured: between random places in two regions.
double straight_km(const City& city, const std::vector<double>& spread_km, int from, int to) {
  const double between =
      distance(LocalFrame(city.regions[from].centroid).local(city.regions[to].centroid), {}) / 1000.0;
  return std::hypot(between, spread_km[from], spread_km[to]);
}

}  // namespace

IngestedCity ingest_counts(const CountSources& sources) {
  CountNotes notes = read_count_notes(sources.notes);
  ZoneFile file = read_bordering_zones(sources.zones, {.name = notes.zone_field, .weight = {}});
  const ZoneCounts counts = read_counts(sources.counts, notes.counts, file.zones, notes.choice);
  const std::vector<double> ends = ends_of(counts, file.zones.size());
  for (std::size_t z = 0; z < file.zones.size(); ++z) {
    file.zones[z].weight = ends[z];
  }
  Partition partition = partition_zones(std::move(file), sources.regions);

  IngestedCity made{std::move(notes.city), {}, {}};
  City& city = made.city;
  city.name += "-" + std::to_string(sources.regions);
  city.regions = partition.regions;
  const std::vector<double> spread = place_regions(partition, ends, city.regions);
  const TravelSample travel = fit_travel(sources.trips, notes.sample, partition.zones, [&](int from, int to) {
    return straight_km(city, spread, partition.region_of[from], partition.region_of[to]);
  });
  set_mean_travel(travel, counts, spread, city);
  const IngestedStations stations = ingest_stations(sources.stations, notes.stations, city.regions, notes.snap_m);
  city.stations = share_of_points(stations.stations, notes.points_share);
  const SessionSample sessions = read_sessions(sources.sessions, notes.session_table, notes.sessions);
  city.charging.session_quantiles = quantiles(sessions.minutes, kLengths);
  made.days = demand_days(city, counts, partition.region_of);

  std::ostringstream out;
  out << counts.report << partition.report << travel.report << stations.report
      << "points for the fleet: " << city.points().sum() << " at " << city.stations.size() << " stations\n"
      << sessions.report;
  made.report = out.str();
  return made;
}

}  // namespace evbal
