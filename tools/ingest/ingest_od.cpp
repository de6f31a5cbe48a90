#include "tools/ingest/ingest_od.hpp"

#include "agents/world/factors.hpp"
#include "agents/world/geometry.hpp"
#include "common/error.hpp"
#include "tools/ingest/cell_trips.hpp"
#include "tools/ingest/course.hpp"
#include "tools/ingest/ingest_partition.hpp"
#include "tools/ingest/od_notes.hpp"
#include "tools/ingest/rounding.hpp"
#include "tools/ingest/trip_end_sums.hpp"
#include "tools/records/record_place.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace evbal {
namespace {

/// The zone of each cell, -1 if it lies too far outside.
std::vector<int> zones_of(const std::vector<LatLon>& cells, const std::vector<Zone>& zones, double snap_m) {
  const OutlineMap map(outlines_of(zones));
  std::vector<int> found;
  found.reserve(cells.size());
  for (const LatLon cell : cells) {
    const auto nearest = map.nearest(cell);
    found.push_back(nearest.metres <= snap_m ? nearest.outline : -1);
  }
  return found;
}

/// The days, their course and the lengths of charging sessions of the city `like`, into `city`.
void take_days(const City& like, double within_day, City& city) {
  city.day_start = like.day_start;
  city.step_minutes = like.step_minutes;
  city.days = like.days;
  city.train_days = like.train_days;
  city.test_days = like.test_days;
  city.holidays = like.holidays;
  city.charging.session_quantiles = like.charging.session_quantiles;
  std::vector<DemandDay> days;
  for (const auto& date : like.days) {
    days.push_back(read_demand(like, date));
  }
  const Course course = course_of(days, like.size());
  city.factors->course = (within_day * course.share).unaryExpr([](double share) { return rounded(share, 1e6); });
  city.factors->region_deviation = rounded(course.region_deviation, 1e3);
}

/// Weighs zones by the trips that start in them.
void weigh(const CellTrips& trips, const std::vector<int>& zone_of, std::vector<Zone>& zones) {
  for (Zone& zone : zones) {
    zone.weight = 0.0;
  }
  for (const auto& [cells, count] : trips.trips) {
    if (zone_of[cells.first] >= 0) {
      zones[zone_of[cells.first]].weight += static_cast<double>(count);
    }
  }
}

/// Trips between the regions of the city, which get their places from them.
struct Pairs {
  std::map<std::pair<int, int>, long long> trips;
  long long used = 0;
  long long outside = 0;
  LatLon first_outside;

  std::string report() const {
    return "trips: " + std::to_string(used + outside) +
           "\n  dropped, an end outside the zones: " + std::to_string(outside) +
           (outside == 0 ? "" : " (first: " + place_text(first_outside) + ")") + "\n";
  }
};

Pairs count_pairs(const CellTrips& trips, const std::vector<int>& zone_of, const std::vector<int>& region_of,
                  double cell_m, City& city) {
  Pairs pairs;
  TripEndSums ends(city.size(), city.regions.front().centroid);
  for (const auto& [cells, count] : trips.trips) {
    const auto [from, to] = cells;
    if (zone_of[from] < 0 || zone_of[to] < 0) {
      pairs.first_outside = pairs.outside > 0 ? pairs.first_outside : trips.cells[zone_of[from] < 0 ? from : to];
      pairs.outside += count;
      continue;
    }
    const int origin = region_of[zone_of[from]];
    const int destination = region_of[zone_of[to]];
    pairs.used += count;
    pairs.trips[{origin, destination}] += count;
    ends.add(origin, trips.cells[from], static_cast<double>(count));
    ends.add(destination, trips.cells[to], static_cast<double>(count));
  }
  city.factors->spread_km = place_regions(ends, cell_m, city.regions);
  for (const auto& [pair, count] : pairs.trips) {
    city.factors->pairs.push_back({pair.first, pair.second, static_cast<int>(count)});
  }
  return pairs;
}

OdCity city_of(const OdSources& sources, OdNotes notes, const CellTrips& trips) {
  ZoneFile zones = read_bordering_zones(sources.zones, {});
  const std::vector<int> zone_of = zones_of(trips.cells, zones.zones, notes.snap_m);
  weigh(trips, zone_of, zones.zones);
  Partition partition = partition_zones(std::move(zones), sources.regions);

  City city = std::move(notes.city);
  city.name += "-" + std::to_string(sources.regions);
  city.regions = std::move(partition.regions);
  const Pairs pairs = count_pairs(trips, zone_of, partition.region_of, notes.trips.cell_m(), city);
  if (pairs.used == 0) {
    throw with_report(
        bad_input(sources.trips.string(), 0,
                  "has no trip between two zones; a zone lies at " + place_text(partition.zones.front().centre)),
        pairs.report() + partition.report);
  }
  take_days(read_city(sources.like), notes.within_day, city);
  const std::string stations = add_stations(sources.stations, notes.stations, notes.snap_m, city);
  set_travel(city);

  std::ostringstream out;
  out << trips.report() << pairs.report() << "trips used: " << pairs.used << " between " << pairs.trips.size()
      << " pairs of regions\n"
      << partition.report << "region deviation from day to day: " << city.factors->region_deviation << "\n"
      << stations;
  return {std::move(city), out.str()};
}

}  // namespace

OdCity ingest_od(const OdSources& sources) {
  OdNotes notes = read_od_notes(sources.notes);
  const CellTrips trips = read_cell_trips(sources.trips, notes.trips);
  try {
    return city_of(sources, std::move(notes), trips);
  } catch (const Error& error) {
    throw with_report(error, trips.report());
  }
}

}  // namespace evbal
