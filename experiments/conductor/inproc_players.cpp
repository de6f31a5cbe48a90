#include "experiments/conductor/inproc_players.hpp"

#include "agents/protocol/origin.hpp"

#include <utility>

namespace evbal {

InprocPlayers::InprocPlayers(const World& world, Planner planner, Injector injector)
    : plants_(make_plants(world)), planner_(std::move(planner)), injector_(std::move(injector)) {}

Faults InprocPlayers::faults(int tick) {
  return with_origin([&] { return injector_(tick); });
}

Exchange InprocPlayers::play(const Tick& tick) {
  Exchange said;
  for (auto& plant : plants_) {
    plant.begin(tick);
  }
  if (tick.plan_due) {
    for (auto& plant : plants_) {
      said.reports.push_back(with_origin([&] { return plant.report(); }));
    }
    said.plan = with_origin([&] { return planner_(tick, said.reports); });
  }
  for (auto& plant : plants_) {
    said.departures.push_back(with_origin([&] { return plant.live(said.plan ? &*said.plan : nullptr); }));
  }
  return said;
}

}  // namespace evbal
