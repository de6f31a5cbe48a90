// Stands in for evbal-agent, evbal-coordinator and evbal-faults, as its name tells it, without plant or solver.

#include "agents/bus/process.hpp"
#include "agents/bus/roles.hpp"
#include "tests/bus/dds/fake_answers.hpp"

namespace {

using namespace evbal;

void be_agent(const ProcessOptions& options, Participant& participant) {
  Tick now;
  const auto of_each_region = [&](auto answer) {
    std::vector<decltype(answer(0))> answers;
    for (int region = options.first_region; region <= options.last_region; ++region) {
      answers.push_back(answer(region));
    }
    return answers;
  };
  serve_agent(participant, options.name,
              {.begin = [&](const Tick& tick) { now = tick; },
               .report = [&] { return of_each_region([&](int region) { return fake::report(now.tick, region); }); },
               .live =
                   [&](const Plan* plan) {
                     return of_each_region([&](int region) { return fake::departures(now, plan, region); });
                   }});
}

}  // namespace

int main(int argc, char** argv) {
  return run_process(argc, argv, "Stand-in for a process of a run",
                     [](const ProcessOptions& options, Participant& participant) {
                       if (options.name == "coordinator") {
                         serve_coordinator(participant, options.name, fake::plan);
                       }
                       if (options.name == "faults") {
                         serve_injector(participant, options.name, fake::faults);
                       }
                       be_agent(options, participant);
                     });
}
