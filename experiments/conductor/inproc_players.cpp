#include "experiments/conductor/inproc_players.hpp"

#include "agents/protocol/origin.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace evbal {

InprocPlayers::InprocPlayers(const World& world, Planner planner, Injector injector, int regions_per_process)
    : plants_(make_plants(world)),
      planner_(std::move(planner)),
      injector_(std::move(injector)),
      regions_per_process_(regions_per_process) {}

Faults InprocPlayers::faults(int tick) {
  return with_origin([&] { return injector_(tick); });
}

Exchange InprocPlayers::play(const Tick& tick) {
  Exchange said;
  for (const int region : tick.due) {
    plants_[region].begin(tick);
  }
  if (tick.plan_due) {
    for (const int region : tick.due) {
      said.reports.push_back(with_origin([&] { return plants_[region].report(); }));
    }
  }
  if (tick.unattended) {
    said.reports.clear();
  } else if (tick.plan_due) {
    std::vector<Report> heard;
    std::copy_if(said.reports.begin(), said.reports.end(), std::back_inserter(heard), [&](const Report& report) {
      return std::find(tick.unheard.begin(), tick.unheard.end(), report.region) == tick.unheard.end();
    });
    said.plan = with_origin([&] { return planner_(tick, heard); });
  }
  for (const int region : tick.due) {
    said.departures.push_back(with_origin([&] { return plants_[region].live(said.plan ? &*said.plan : nullptr); }));
  }
  return said;
}

}  // namespace evbal
