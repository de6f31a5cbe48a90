#pragma once

#include "agents/city/city.hpp"
#include "agents/protocol/messages.hpp"
#include "common/clock.hpp"

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace evbal {

/// Everything that the plants of one run share. Owned by the process; the plants keep a reference.
struct World {
  City city;  ///< with the scenario's overrides applied
  DayClock clock;
  std::uint64_t seed = 0;
};

/// A passenger who will appear: drawn before the day, the same for every controller.
struct Passenger {
  int appears = 0;   ///< minute
  int patience = 0;  ///< minutes
  int destination = 0;
  int index = 0;  ///< position among the region's passengers; keys what faults draw for this one
};

/// How recorded counts become passengers.
enum class DemandModel {
  recorded,  ///< as many as on record, minutes drawn within the step
  poisson,   ///< Poisson around the record
};

/// The passengers of one region on one day, by (appears, index).
std::vector<Passenger> draw_passengers(const World& world, const DemandDay& day, DemandModel model, int region);

/// Start regions and charge of the fleet: one list per region, by vehicle id.
std::vector<std::vector<Vehicle>> draw_fleet(const World& world, const DemandDay& day);

/// One region as it really is: whole vehicles, minute by minute. Per tick call begin, then report if a plan is due,
/// then live.
class RegionPlant {
 public:
  RegionPlant(const World& world, int region, std::vector<Passenger> passengers, std::vector<Vehicle> vacant);

  /// Takes this region's arrivals and effects of the tick.
  void begin(const Tick& tick);

  /// The region before anything moves.
  Report report();

  /// Sends off what the plan asks for as far as it is there, and lives through the tick's minutes.
  /// `plan` is null where none is due.
  Departures live(const Plan* plan);

  int region() const;
};

}  // namespace evbal
