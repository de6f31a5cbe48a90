#pragma once

#include "agents/protocol/message_check.hpp"
#include "agents/protocol/messages.hpp"
#include "agents/world/city.hpp"
#include "agents/world/draws.hpp"
#include "agents/world/world.hpp"
#include "common/clock.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace evbal {

/// What one region's plant needs of the world, all drawn and looked up. A plain struct: an agent is handed it as bytes
/// and reads no city pack.
struct RegionWorld {
  int region = 0;                     ///< which it is
  int points = 0;                     ///< charging points installed there
  int station = -1;                   ///< nearest region with points, itself if it has some; -1 if none has
  std::uint64_t seed = 0;             ///< of all that is drawn
  DayClock clock;                     ///< of the run
  FleetAssumption fleet;              ///< of the city
  ChargingAssumption charging;        ///< of the city
  PassengerAssumption patience;       ///< of the city
  std::vector<double> km;             ///< from here to each region
  std::vector<double> km_to_station;  ///< from each region to the nearest with points; 0 if none has
  std::vector<double> minutes;        ///< from here to each region
  std::vector<Passenger> passengers;  ///< of the day, as draw_passengers gives them
  std::vector<Vehicle> vehicles;      ///< that are here at the day's start
};

/// Each region's part of the world, by region.
std::vector<RegionWorld> region_worlds(const World& world);

/// What an agent's process is told of the world.
struct AgentWorld {
  MessageBounds bounds;              ///< of the run's messages
  std::vector<RegionWorld> regions;  ///< that it hosts
};

/// Writes the file for the agent that hosts [first, last]. Throws Error{run_failed} if it cannot be written.
void write_agent_world(const std::filesystem::path& file, const World& world, const std::vector<RegionWorld>& regions,
                       int first, int last);

/// Reads it. Throws Error{run_failed} if it is not there or no such file.
AgentWorld read_agent_world(const std::filesystem::path& file);

}  // namespace evbal
