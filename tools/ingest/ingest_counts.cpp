#include "tools/ingest/ingest_counts.hpp"

#include "agents/world/factors.hpp"
#include "common/error.hpp"
#include "tools/ingest/count_notes.hpp"
#include "tools/ingest/day_trips.hpp"
#include "tools/ingest/ingest_partition.hpp"
#include "tools/ingest/rounding.hpp"
#include "tools/ingest/trip_end_sums.hpp"
#include "tools/ingest/zone_places.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

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
std::vector<double> place_evenly(const Partition& partition, const std::vector<double>& ends,
                                 std::vector<Region>& regions) {
  TripEndSums places(static_cast<int>(regions.size()), regions.front().centroid);
  const ZonePlaces within(partition.zones);
  for (std::size_t z = 0; z < partition.zones.size(); ++z) {
    // A zone without trips counts a little, so that its region has a place and a size.
    const double weight = std::max(ends[z], 1e-6) / kPlaces;
    for (std::uint64_t draw = 0; draw < kPlaces; ++draw) {
      places.add(partition.region_of[z], *within.place(partition.zones[z].name, draw), weight);
    }
  }
  return place_regions(places, 0.0, regions);
}

std::vector<DayTrips> day_trips(const ZoneCounts& counts, const std::vector<int>& region_of, std::size_t days) {
  std::vector<DayTrips> trips(days);
  for (const ZoneCount& cell : counts.cells) {
    trips[cell.day][{cell.step, region_of[cell.from], region_of[cell.to]}] += cell.trips;
  }
  return trips;
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
  const std::vector<double> spread = place_evenly(partition, ends, city.regions);
  const TravelSample travel = fit_travel(sources.trips, notes.sample, partition.zones, [&](int from, int to) {
    return straight_km(city, spread, partition.region_of[from], partition.region_of[to]);
  });
  set_mean_travel(travel, counts, spread, city);
  const std::string stations = add_stations(sources.stations, notes.stations, notes.snap_m, city);
  const SessionSample sessions = read_sessions(sources.sessions, notes.session_table, notes.sessions);
  city.charging.session_quantiles = quantiles(sessions.minutes, kLengths);
  made.days = demand_days(city, day_trips(counts, partition.region_of, city.days.size()));

  std::ostringstream out;
  out << counts.report << partition.report << travel.report << stations << sessions.report;
  made.report = out.str();
  return made;
}

}  // namespace evbal
