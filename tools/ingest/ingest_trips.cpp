#include "tools/ingest/ingest_trips.hpp"

#include "common/error.hpp"
#include "tools/ingest/day_trips.hpp"
#include "tools/ingest/merge_zones.hpp"
#include "tools/ingest/outlines.hpp"
#include "tools/ingest/rounding.hpp"
#include "tools/ingest/sessions.hpp"
#include "tools/ingest/stations.hpp"
#include "tools/ingest/travel.hpp"
#include "tools/ingest/trips.hpp"
#include "tools/records/record_place.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <memory>
#include <sstream>

namespace evbal {
namespace {

constexpr double kPriorTrips = 10.0;  // weight of the travel law against a pair's own trips
constexpr int kSessionQuantiles = 21;

/// The trips of the sources, to be streamed as often as one likes.
class TripStream {
 public:
  TripStream(const TripSources& sources, const CityNotes& notes)
      : format_(sources.format.empty() ? own_trip_format() : read_trip_format(sources.format)),
        file_(read_zones(sources.zones, {.name = format_.zone_field, .weight = {}})),
        folder_(sources.trips),
        notes_(notes) {}

  RowCount for_each(const UseTrip& use) const { return for_each_trip(folder_, format_, zones(), notes_, use); }

  const std::vector<Zone>& zones() const { return file_.zones; }

  const std::string& zones_report() const { return file_.report; }

 private:
  TripFormat format_;
  ZoneFile file_;
  std::filesystem::path folder_;
  const CityNotes& notes_;
};

/// Weighs the zones; `rows` tells what was read of the trips.
ZoneWeights weigh_zones(const TripSources& sources, const CityNotes& notes, const TripStream& trips_on_record,
                        RowCount& rows) {
  const std::vector<Zone>& zones = trips_on_record.zones();
  const std::vector<Outline> outlines = outlines_of(zones);
  const OutlineMap map(outlines);
  ZoneWeights weights{std::vector<double>(zones.size(), 0.0), std::vector<double>(zones.size(), 0.0), {}};
  double trips = 0.0;
  std::string first;  // trip, if it starts in no zone
  const auto& training = notes.city.train_days;
  const double reference = zones.front().centre.lon;
  rows = trips_on_record.for_each([&](const Trip& trip) -> std::string_view {
    const auto zone = map.containing(trip.from);
    const auto end = map.containing(trip.to);
    if (end) {
      weights.ends[*end] += 1.0;
    }
    if (!zone) {
      first = first.empty() ? place_text(trip.from) : first;
      return {};
    }
    weights.ends[*zone] += 1.0;
    if (std::binary_search(training.begin(), training.end(), notes.city.days[trip.day])) {
      weights.pickups[*zone] += 1.0;
      weights.mean_pickup.lat += trip.from.lat;
      weights.mean_pickup.lon += longitude_near(trip.from.lon, reference);
      trips += 1.0;
    }
    return {};
  });
  if (trips == 0.0) {
    const Error error = bad_input(
        sources.trips.string(), 0,
        "no trip of the training days starts in a zone" +
            (first.empty() ? "" : "; one starts at " + first + ", a zone lies at " + place_text(zones.front().centre)));
    throw with_report(error, rows.report());
  }
  weights.mean_pickup = {weights.mean_pickup.lat / trips, longitude_near(weights.mean_pickup.lon / trips, 0.0)};
  return weights;
}

/// Trips between regions.
struct Counts {
  std::vector<DayTrips> days;
  Eigen::VectorXd ends;  ///< pick-ups and drop-offs of each region
  Eigen::VectorXd pickups;
  long long snapped = 0;  ///< with an end outside the zones but near
  RowCount rows;
};

/// Says in which region a point lies.
class RegionFinder {
 public:
  RegionFinder(const std::vector<Zone>& zones, const std::vector<int>& region_of, double snap_m) : snap_m_(snap_m) {
    const std::vector<Outline> all = outlines_of(zones);
    std::vector<Outline> kept;
    for (std::size_t z = 0; z < zones.size(); ++z) {
      if (region_of[z] >= 0) {
        kept.push_back(all[z]);
        regions_.push_back(region_of[z]);
      }
    }
    map_ = std::make_unique<OutlineMap>(kept);
  }

  struct Found {
    int region = -1;  ///< -1 if too far outside
    bool inside = false;
  };

  Found find(LatLon point) const {
    const auto nearest = map_->nearest(point);
    return {nearest.metres <= snap_m_ ? regions_[nearest.outline] : -1, nearest.metres == 0.0};
  }

 private:
  double snap_m_;
  std::vector<int> regions_;  ///< by outline
  std::unique_ptr<OutlineMap> map_;
};

Counts count_trips(const TripSources& sources, const CityNotes& notes, const TripStream& trips_on_record,
                   const RegionFinder& finder, TravelSums& travel) {
  const int regions = sources.regions;
  Counts counts;
  counts.days.resize(notes.city.days.size());
  counts.ends = Eigen::VectorXd::Zero(regions);
  counts.pickups = counts.ends;
  counts.rows = trips_on_record.for_each([&](const Trip& trip) -> std::string_view {
    const auto from = finder.find(trip.from);
    const auto to = finder.find(trip.to);
    if (from.region < 0 || to.region < 0) {
      return "an end outside the regions";
    }
    counts.snapped += from.inside && to.inside ? 0 : 1;
    ++counts.days[trip.day][{trip.step, from.region, to.region}];
    counts.pickups[from.region] += 1.0;
    counts.ends[from.region] += 1.0;
    counts.ends[to.region] += 1.0;
    travel.add(from.region, to.region, trip);
    return {};
  });
  for (std::size_t d = 0; d < counts.days.size(); ++d) {
    if (counts.days[d].empty()) {
      throw with_report(bad_input(sources.trips.string(), 0, "has no trip of " + notes.city.days[d]),
                        counts.rows.report());
    }
  }
  return counts;
}

void add_regions(City& city, const std::vector<Zone>& zones, const MergedZones& merged, const TravelSums& travel) {
  const auto regions = static_cast<int>(merged.names.size());
  const auto outlines = merged_outlines(zones, merged.region_of, regions, outline_tolerance_m);
  std::vector<LatLon> corners;
  corners.reserve(outlines.size());
  for (const auto& outline : outlines) {
    corners.push_back(outline.front().front());
  }
  const auto centroids = travel.centroids(corners);
  for (int r = 0; r < regions; ++r) {
    city.regions.push_back({merged.names[r], outlines[r], rounded(centroids[r])});
  }
}

void add_travel(City& city, const TravelSums& travel, double detour) {
  std::vector<LatLon> centroids;
  for (const auto& region : city.regions) {
    centroids.push_back(region.centroid);
  }
  const auto matrices = travel.matrices(centroids, detour, kPriorTrips);
  city.km = matrices.km.unaryExpr([](double km) { return rounded(km, 100.0); });
  city.minutes = matrices.minutes.unaryExpr([](double minutes) { return rounded(minutes, 10.0); });
}

void add_stations(City& city, const Counts& counts, const CityNotes& notes) {
  for (const auto& choice : choose_stations(city.km, counts.ends, notes.stations, notes.points)) {
    const Region& region = city.regions[choice.region];
    city.stations.push_back({"s-" + region.name, choice.region, choice.points, region.centroid});
  }
}

std::string report_of(const City& city, const Counts& counts, const TravelLaw& law, const SessionSample& sessions) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(2);
  out << counts.rows.report() << "trips used: " << counts.rows.used << " on " << city.days.size() << " days\n"
      << "  with an end moved to the nearest zone: " << counts.snapped << "\n"
      << "regions: " << city.size() << ", pick-ups each from " << std::lround(counts.pickups.minCoeff()) << " to "
      << std::lround(counts.pickups.maxCoeff()) << ", mean " << std::lround(counts.pickups.mean()) << "\n"
      << "travel law: minutes = " << law.start << " + " << law.per_km << " * km\n"
      << "stations: " << city.stations.size() << ", points: " << city.points().sum() << "\n"
      << sessions.report;
  return out.str();
}

MergedZones merged_by(const ZoneWeights& weights, const RowCount& rows, const TripStream& trips, const CityNotes& notes,
                      int regions) {
  try {
    return merge_zones(trips.zones(), weights, notes, regions);
  } catch (const Error& error) {
    throw with_report(error, rows.report());
  }
}

IngestedCity city_of(const TripSources& sources, const CityNotes& notes, const TripStream& trips) {
  const std::vector<Zone>& zones = trips.zones();
  RowCount rows;
  const ZoneWeights weights = weigh_zones(sources, notes, trips, rows);
  const MergedZones merged = merged_by(weights, rows, trips, notes, sources.regions);
  const RegionFinder finder(zones, merged.region_of, notes.snap_m);
  TravelSums travel(sources.regions, weights.mean_pickup);
  const Counts counts = count_trips(sources, notes, trips, finder, travel);
  const SessionSample sessions = read_sessions(
      sources.sessions,
      sources.session_format.empty() ? dundee_session_format() : read_session_format(sources.session_format),
      notes.sessions);

  IngestedCity made{notes.city, {}, {}};
  City& city = made.city;
  city.charging.session_quantiles = quantiles(sessions.minutes, kSessionQuantiles);
  add_regions(city, zones, merged, travel);
  add_travel(city, travel, notes.detour);
  add_stations(city, counts, notes);
  made.days = demand_days(city, counts.days);
  made.report = trips.zones_report() + merged.left_out + report_of(city, counts, travel.law(), sessions);
  return made;
}

}  // namespace

IngestedCity ingest_trips(const TripSources& sources) {
  const CityNotes notes = read_notes(sources.notes);
  if (notes.stations > sources.regions) {
    throw bad_input(sources.notes.string(), 0, "more stations than regions; give at most one a region");
  }
  const TripStream trips(sources, notes);
  try {
    return city_of(sources, notes, trips);
  } catch (const Error& error) {
    throw with_report(error, trips.zones_report());
  }
}

}  // namespace evbal
