#include "tools/gps/track.hpp"

#include <limits>
#include <utility>

namespace evbal {
namespace {

constexpr double kSnap = 500.0;  // m outside all regions up to which the nearest counts

}  // namespace

TrackMap::TrackMap(std::vector<Region> all_regions, std::vector<Station> all_stations, LocalClock local,
                   const ChargingRule& charging)
    : regions(std::move(all_regions)), stations(std::move(all_stations)), clock(std::move(local)), rule(charging) {
  if (!regions.empty()) {
    region_map.emplace(regions, kSnap);
  }
  if (!stations.empty()) {
    station_map.emplace(stations, rule.within_m);
  }
}

Track::Track(const TrackMap& map) : map_(map), rides_(map.rule.longest_gap) {
  if (map.station_map) {
    stops_.emplace(*map.station_map, map.rule);
  }
  if (map.region_map) {
    log_.emplace(*map.region_map, map.clock, map.rule.longest_gap);
  }
}

void Track::note(const std::vector<ChargingStop>& stops) {
  for (const ChargingStop& stop : stops) {
    log_->add(stop, map_.stations[stop.station].region);
  }
}

TrackEvents Track::add(const Fix& fix, TransitionCounter& counter) {
  TrackEvents events;
  const RideFinder::Found found = rides_.add(fix);
  events.ride = found.ride;
  events.vacant = found.vacant;
  if (log_) {
    log_->add(fix);
  }
  if (stops_) {
    events.stops = stops_->add(fix);
    note(events.stops);
  }
  if (log_) {
    const auto open = stops_ ? stops_->open_since() : std::nullopt;
    events.outside = log_->settle(open.value_or(fix.time), counter);
  }
  return events;
}

TrackEvents Track::finish(TransitionCounter& counter) {
  TrackEvents events;
  events.vacant = rides_.finish();
  if (stops_) {
    events.stops = stops_->finish();
    note(events.stops);
  }
  if (log_) {
    events.outside = log_->settle(std::numeric_limits<long long>::max(), counter);
  }
  return events;
}

}  // namespace evbal
