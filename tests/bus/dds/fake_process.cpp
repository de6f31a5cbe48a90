// Stands in for evbal-agent, evbal-coordinator and evbal-faults, as its name tells it, without plant or solver.

#include "agents/hosting/process.hpp"
#include "agents/hosting/roles.hpp"
#include "tests/bus/dds/fake_answers.hpp"

#include <csignal>

namespace {

using namespace evbal;

[[noreturn]] void be_agent(const ProcessOptions& options, Participant& participant) {
  Tick now;
  std::vector<HostedRegion> regions;
  for (int region = options.first_region; region <= options.last_region; ++region) {
    regions.push_back({.begin = [&now](const Tick& tick) { now = tick; },
                       .report = [&now, region] { return fake::report(now.tick, region); },
                       .live =
                           [&now, region](const Plan* plan) {
                             if (now.tick == fake::deadly_tick && region == 1) {
                               raise(SIGKILL);
                             }
                             return fake::departures(now, plan, region);
                           }});
  }
  serve_agent(participant, options, regions);
}

}  // namespace

int main(int argc, char** argv) {
  return run_process(
      argc, argv, "Stand-in for a process of a run", [](const ProcessOptions& options, Participant& participant) {
        if (options.name == "coordinator") {
          serve_coordinator(participant, options,
                            {.plan = fake::plan, .memory = [] { return ""; }, .recall = [](auto&&...) {}});
        }
        if (options.name == "faults") {
          serve_injector(participant, options, {.faults = fake::faults});
        }
        be_agent(options, participant);
      });
}
