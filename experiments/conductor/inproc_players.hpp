#pragma once

#include "agents/region/region_plant.hpp"
#include "experiments/conductor/players.hpp"

#include <functional>
#include <vector>

namespace evbal {

/// The reports that reach the coordinator in time.
std::vector<Report> heard_in_time(const Tick& tick, const std::vector<Report>& reports);

/// The others as objects in this process, by direct calls.
class InprocPlayers : public Players {
 public:
  /// Makes the plan of a tick from its reports.
  using Planner = std::function<Plan(const Tick& tick, const std::vector<Report>& reports)>;
  /// Says which faults are active in a tick.
  using Injector = std::function<Faults(int tick)>;

  /// `world` must outlive the players. Processes that are taken away keep what they know, as over DDS: here nothing
  /// needs to be done.
  InprocPlayers(const World& world, Planner planner, Injector injector, int regions_per_process = 1);

  Faults faults(int tick) override;
  Exchange play(const Tick& tick) override;

  /// The first half of play(), up to the reports. Where a plan is due and the tick is not `unattended`, the plan is to
  /// be added; then comes live().
  Exchange report(const Tick& tick);

  /// The second half of play(): the regions live through the tick and say so.
  void live(const Tick& tick, Exchange& said);

  int regions_per_process() const override { return regions_per_process_; }

  /// The regions as they stand.
  const std::vector<RegionPlant>& plants() const { return plants_; }

 private:
  std::vector<RegionPlant> plants_;
  Planner planner_;
  Injector injector_;
  int regions_per_process_;
};

}  // namespace evbal
