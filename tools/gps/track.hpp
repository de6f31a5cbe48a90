#pragma once

#include "tools/gps/state_log.hpp"

#include <optional>
#include <vector>

namespace evbal {

/// What the tracks of all vehicles are read against. Without regions there are no transitions, without stations no
/// charging stops; stations lie in regions.
struct TrackMap {
  std::vector<Region> regions;
  std::vector<Station> stations;
  std::optional<RegionMap> region_map;
  std::optional<StationMap> station_map;
  LocalClock clock{0};
  ChargingRule rule;

  TrackMap(std::vector<Region> all_regions, std::vector<Station> all_stations, LocalClock local,
           const ChargingRule& charging);
};

/// What a vehicle has done by now, as its fixes tell.
struct TrackEvents {
  std::optional<Ride> ride;
  std::optional<VacantMove> vacant;
  std::vector<ChargingStop> stops;
};

/// The fixes of one vehicle.
class Track {
 public:
  explicit Track(const TrackMap& map);

  /// The fix that follows in time. Counts transitions once they are known for good.
  TrackEvents add(const Fix& fix, TransitionCounter& counter);

  /// What the end of the records brings.
  TrackEvents finish(TransitionCounter& counter);

  /// RideFinder::cut_off
  int cut_off() const { return rides_.cut_off(); }

 private:
  void note(const std::vector<ChargingStop>& stops);

  const TrackMap& map_;
  RideFinder rides_;
  std::optional<StopFinder> stops_;
  std::optional<StateLog> log_;
};

}  // namespace evbal
