#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/world/world.hpp"
#include "common/eigen.hpp"

#include <functional>
#include <vector>

namespace evbal {

/// A passenger who will appear: drawn before the day, the same for every controller.
struct Passenger {
  int appears = 0;      ///< minute
  int patience = 0;     ///< minutes
  int destination = 0;  ///< region
  int index = 0;        ///< position among the region's passengers; keys what faults draw for this one
};

/// The passengers of one region on the world's day, by (appears, index). Those whom the record has outside the clock's
/// day are left out.
std::vector<Passenger> draw_passengers(const World& world, int region);

/// The passengers who will appear in each tick, N x ticks: drawn passengers times the factors of `effects` on their
/// region, and passengers whom effects add.
Eigen::MatrixXd demand_by_tick(const World& world, const std::function<std::vector<Effect>(int tick)>& effects);

/// A passenger's patience, uniform between the city's bounds, in whole minutes.
int draw_patience(const PassengerAssumption& passengers, double uniform);

/// Start regions and charge of the fleet: one list per region, by vehicle id. Regions are drawn in proportion to the
/// day's pick-ups, evenly if there are none.
std::vector<std::vector<Vehicle>> draw_fleet(const World& world);

/// Minutes of a vehicle's `session`-th charging session: from the quantiles, linear in between, at least 1.
int draw_session(const ChargingAssumption& charging, std::uint64_t seed, int vehicle, int session);

}  // namespace evbal
