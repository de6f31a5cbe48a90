#include "experiments/conductor/inproc_players.hpp"

#include "agents/protocol/origin.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace evbal {

std::vector<Report> heard_in_time(const Tick& tick, const std::vector<Report>& reports) {
  std::vector<Report> heard;
  std::copy_if(reports.begin(), reports.end(), std::back_inserter(heard), [&](const Report& report) {
    return std::find(tick.unheard.begin(), tick.unheard.end(), report.region) == tick.unheard.end();
  });
  return heard;
}

InprocPlayers::InprocPlayers(const World& world, Planner planner, Injector injector, int regions_per_process)
    : plants_(make_plants(world)),
      planner_(std::move(planner)),
      injector_(std::move(injector)),
      regions_per_process_(regions_per_process) {}

Faults InprocPlayers::faults(int tick) {
  return legs().time("faults", [&] { return with_origin([&] { return injector_(tick); }); });
}

Exchange InprocPlayers::report(const Tick& tick) {
  Exchange said;
  legs().time("reports", [&] {
    for (const int region : tick.due) {
      plants_[region].begin(tick);
      if (tick.plan_due) {
        said.reports.push_back(with_origin([&] { return plants_[region].report(); }));
      }
    }
  });
  if (tick.unattended) {
    said.reports.clear();
  }
  return said;
}

void InprocPlayers::live(const Tick& tick, Exchange& said) {
  legs().time("departures", [&] {
    for (const int region : tick.due) {
      said.departures.push_back(with_origin([&] { return plants_[region].live(said.plan ? &*said.plan : nullptr); }));
    }
  });
}

Exchange InprocPlayers::play(const Tick& tick) {
  Exchange said = report(tick);
  if (tick.plan_due && !tick.unattended) {
    said.plan = legs().time(
        "plan", [&] { return with_origin([&] { return planner_(tick, heard_in_time(tick, said.reports)); }); });
  }
  live(tick, said);
  return said;
}

}  // namespace evbal
