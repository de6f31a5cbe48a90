#pragma once

#include "agents/world/geometry.hpp"
#include "tools/fit/transition_counts.hpp"
#include "tools/gps/charging_stops.hpp"
#include "tools/gps/rides.hpp"
#include "tools/records/local_clock.hpp"

#include <vector>

namespace evbal {

/// Says in which region a place lies.
class RegionMap {
 public:
  /// Places up to `snap_m` metres outside all regions belong to the nearest.
  RegionMap(const std::vector<Region>& regions, double snap_m) : outlines_(outlines_of(regions)), snap_m_(snap_m) {}

  /// The region of a place; -1 if it lies further than `snap_m` from all.
  int region_of(LatLon place) const {
    const auto nearest = outlines_.nearest(place);
    return nearest.metres <= snap_m_ ? nearest.outline : -1;
  }

 private:
  OutlineMap outlines_;
  double snap_m_;
};

/// Region transitions by time of day, counted from what single vehicles did (docs/model.md, section 2).
class TransitionCounter {
 public:
  /// Counts nothing yet.
  explicit TransitionCounter(int regions);

  /// A vehicle was at `start` at this local time, and half an hour later at `end`.
  void add(long long local_time, const CarPlace& start, const CarPlace& end);

  /// The counts, one for each of transition_periods().
  const std::vector<TransitionCounts>& periods() const { return periods_; }

 private:
  std::vector<TransitionCounts> periods_;
};

/// A moment at which a vehicle, or the end of its ride, lies in no region.
struct Outside {
  long long time = 0;  ///< UTC seconds
  LatLon place;        ///< of the vehicle, or of the end of its ride
};

/// The state of one vehicle every ten minutes: vacant where it is, occupied where its ride ends, waiting for a charger
/// or plugged at its station. Left out: gaps of the records, rides that do not end, and places outside the regions.
class StateLog {
 public:
  /// `longest_gap` in minutes. Regions and clock must outlive this.
  StateLog(const RegionMap& regions, const LocalClock& clock, double longest_gap)
      : regions_(regions), clock_(clock), longest_gap_(longest_gap) {}

  /// The fix that follows in time.
  void add(const Fix& fix);

  /// A stop at a station in that region, given after the fixes it lasts for.
  void add(const ChargingStop& stop, int region);

  /// Counts what happened up to `until`, and returns the moments since the last call that were left out because they
  /// are outside the regions. No stop that began before `until` may be added later.
  std::vector<Outside> settle(long long until, TransitionCounter& counter);

 private:
  struct Sample {
    long long time = 0;
    long long fix = 0;  ///< time of the last fix before it
    CarPlace car;       ///< region -1: outside all
    LatLon place;       ///< of the vehicle, or of the end of its ride
    bool known = false;
  };

  void add_samples(const Fix& next);
  void end_ride(const Fix& dropoff);

  const RegionMap& regions_;
  const LocalClock& clock_;
  double longest_gap_;
  std::vector<Sample> samples_;  ///< ascending in time
  std::optional<Fix> last_;
  std::optional<long long> ride_from_;  ///< of the ride under way
  long long settled_ = 0;
};

}  // namespace evbal
