#pragma once

#include "agents/region/region_plant.hpp"
#include "experiments/conductor/players.hpp"

#include <functional>
#include <vector>

namespace evbal {

/// The others as objects in this process, by direct calls.
class InprocPlayers : public Players {
 public:
  using Planner = std::function<Plan(const Tick& tick, const std::vector<Report>& reports)>;
  using Injector = std::function<Faults(int tick)>;

  /// `world` must outlive the players.
  InprocPlayers(const World& world, Planner planner, Injector injector);

  Faults faults(int tick) override;
  Exchange play(const Tick& tick) override;

  const std::vector<RegionPlant>& plants() const { return plants_; }

 private:
  std::vector<RegionPlant> plants_;
  Planner planner_;
  Injector injector_;
};

}  // namespace evbal
