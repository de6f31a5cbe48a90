// evbal-agent: hosts one or more regions of a run.

#include "agents/hosting/process.hpp"
#include "agents/hosting/roles.hpp"
#include "agents/protocol/message_check.hpp"
#include "agents/region/region_plant.hpp"
#include "agents/world/world.hpp"

namespace {

using namespace evbal;

void host(const ProcessOptions& options, Participant& participant) {
  YamlMap scenario(YamlValue::load(options.scenario));
  const World world = read_world(scenario);
  const MessageBounds bounds = bounds_of(world);
  std::deque<RegionPlant> plants;
  std::vector<HostedRegion> regions;
  for (int region = options.first_region; region <= options.last_region; ++region) {
    RegionPlant& plant = plants.emplace_back(make_plant(world, region));
    const auto begin = [&plant, &bounds](const Tick& tick) {
      refuse_garbage(tick, bounds, "the conductor");
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
  return evbal::run_process(argc, argv, "Hosts regions of a run; started by evbal run", host);
}
