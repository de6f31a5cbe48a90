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
  RegionMap(const std::vector<Region>& regions, double snap_m) : outlines_(outlines_of(regions)), snap_m_(snap_m) {}

  /// -1 if it lies in none and further than `snap_m` from the nearest.
  int region_of(LatLon place) const {
    const auto nearest = outlines_.nearest(place);
    return nearest.metres <= snap_m_ ? nearest.outline : -1;
  }

 private:
  OutlineMap outlines_;
  double snap_m_;
};

/// Region transitions by time of day, counted from what single vehicles did (model, section 2).
class TransitionCounter {
 public:
  explicit TransitionCounter(int regions);

  /// Minutes after midnight at which each period begins; the last ends at midnight.
  static const std::vector<int>& period_starts();

  /// A vehicle was at `start` at this local time, and half an hour later at `end`.
  void add(long long local_time, const CarPlace& start, const CarPlace& end);

  const std::vector<TransitionCounts>& periods() const { return periods_; }

 private:
  std::vector<TransitionCounts> periods_;
};

/// What one vehicle was, every ten minutes: vacant where it is, occupied where its ride ends, waiting for a charger or
/// plugged at its station. Nothing is known in gaps of the records, of rides that do not end, or outside the regions.
class StateLog {
 public:
  StateLog(const RegionMap& regions, const LocalClock& clock, double longest_gap)
      : regions_(regions), clock_(clock), longest_gap_(longest_gap) {}

  /// The fix that follows in time.
  void add(const Fix& fix);

  /// A stop at a station in that region, told after the fixes.
  void add(const ChargingStop& stop, int region);

  /// Counts what is known for good up to `until`: no stop that began before will still be told.
  void settle(long long until, TransitionCounter& counter);

 private:
  struct Sample {
    long long time = 0;
    long long fix = 0;  ///< time of the last fix before, which tells
    CarPlace car;
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
