// evbal-agent: hosts one or more regions of a run, or keeps those who do on another host.

#include "agents/hosting/keeper.hpp"
#include "agents/hosting/process.hpp"
#include "agents/hosting/roles.hpp"
#include "agents/protocol/message_check.hpp"
#include "agents/region/region_plant.hpp"
#include "agents/region/region_world.hpp"

#include <deque>
#include <string_view>

namespace {

using namespace evbal;

void host(const ProcessOptions& options, Participant& participant) {
  AgentWorld world = read_agent_world(options.world);
  std::deque<RegionPlant> plants;
  std::vector<HostedRegion> regions;
  for (RegionWorld& region : world.regions) {
    RegionPlant& plant = plants.emplace_back(std::move(region));
    const auto begin = [&plant, &world](const Tick& tick) {
      refuse_garbage(tick, world.bounds, "the conductor");
      plant.begin(tick);
    };
    regions.push_back({.begin = begin,
                       .report = [&plant] { return plant.report(); },
                       .live = [&plant](const Plan* plan) { return plant.live(plan); }});
  }
  serve_agent(participant, options, regions);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == evbal::keeper_word) {
    return evbal::run_keeper(argc, argv);
  }
  return evbal::run_process(argc, argv, "Hosts regions of a run; started by evbal run", host);
}
