#pragma once

#include "agents/protocol/messages.hpp"

#include <set>
#include <vector>

namespace evbal {

/// A vehicle on the road.
struct RoadPlace {
  int vehicle = 0;                    ///< its id
  int destination = 0;                ///< region
  Errand errand = Errand::passenger;  ///< why it is on the road
};

/// The vehicles under way, and which region holds each of the others. Once per tick: hand_out, then take what each
/// region says.
class Roads {
 public:
  /// `fleet`: the vehicles that start in each region.
  explicit Roads(const std::vector<std::vector<Vehicle>>& fleet);

  /// Takes off the road, and hands to their regions, the vehicles that arrive before `minute`:
  /// by (region, minute, vehicle). Those bound for a `closed` region wait on the road; once it is open they arrive at
  /// minute `now` at the earliest.
  std::vector<Arrival> hand_out(int minute, int now = 0, const std::set<int>& closed = {});

  /// Those that stay on the road, by (region, minute, errand).
  std::vector<UnderWay> under_way() const;

  /// Puts on the road what left a region during the tick that ends at `tick_end`. Throws Error{run_failed} naming tick
  /// and region if it sends a vehicle that it does not hold, to nowhere, or into the past.
  void take(const Departures& departures, int tick_end);

  /// Vehicles on the road.
  int count() const { return static_cast<int>(on_road_.size()); }

  /// Vehicles that `region` must have.
  int held_by(int region) const { return held_[region]; }

  /// Every vehicle on the road, by id.
  std::vector<RoadPlace> census() const;

 private:
  std::vector<Arrival> on_road_;  ///< by (region, minute, vehicle)
  std::vector<int> holder_;       ///< by vehicle: its region, or on_the_road
  std::vector<int> held_;         ///< by region
};

}  // namespace evbal
