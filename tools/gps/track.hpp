#pragma once

#include "tools/gps/state_log.hpp"

#include <optional>
#include <vector>

namespace evbal {

/// What the tracks of all vehicles are read against. Without regions there are no transitions, without stations no
/// charging stops; stations lie in regions.
struct TrackMap {
  std::vector<Region> regions;            ///< of the city; empty: no transitions
  std::vector<Station> stations;          ///< of the city; empty: no charging stops
  std::optional<RegionMap> region_map;    ///< with regions
  std::optional<StationMap> station_map;  ///< with stations
  LocalClock clock{0};                    ///< of the city
  ChargingRule rule;                      ///< which stays count as charging

  /// Makes the two maps of regions and stations.
  TrackMap(std::vector<Region> all_regions, std::vector<Station> all_stations, LocalClock local,
           const ChargingRule& charging);
};

/// What a fix, or the end of the records, completes.
struct TrackEvents {
  std::optional<Ride> ride;          ///< that has ended
  std::optional<VacantMove> vacant;  ///< that has ended
  std::vector<ChargingStop> stops;   ///< that have ended, in the order of time
  std::vector<Outside> outside;      ///< moments that are in no transition for it, in the order of time
};

/// Follows one vehicle from fix to fix.
class Track {
 public:
  /// `map` must outlive this.
  explicit Track(const TrackMap& map);

  /// The fix that follows in time. Counts transitions that later fixes cannot change.
  TrackEvents add(const Fix& fix, TransitionCounter& counter);

  /// Ends the records of this vehicle.
  TrackEvents finish(TransitionCounter& counter);

  /// Rides that were under way when the records began or ended (RideFinder::cut_off).
  int cut_off() const { return rides_.cut_off(); }

 private:
  void note(const std::vector<ChargingStop>& stops);

  const TrackMap& map_;
  RideFinder rides_;
  std::optional<StopFinder> stops_;
  std::optional<StateLog> log_;
};

}  // namespace evbal
