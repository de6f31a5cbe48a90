#include "experiments/run/twins.hpp"

#include "common/error.hpp"
#include "experiments/record/paired_run.hpp"

namespace evbal {

std::vector<Run> runs_of(const Scenario& scenario, const std::filesystem::path& folder) {
  std::vector<Run> runs;
  runs.reserve(scenario.controllers.size());
  for (const auto& controller : scenario.controllers) {
    runs.push_back(
        {with_controller(scenario, controller), scenario.controllers.size() == 1 ? folder : folder / controller});
  }
  return runs;
}

RunResult record(const Run& run, bool quiet) {
  const Scenario& scenario = run.scenario;
  return record_day(scenario, resolved_yaml(scenario, scenario.planning.controller), run.folder,
                    {.transport = scenario.transport, .quiet = quiet});
}

Twins::Twins(const std::vector<Run>& runs) {
  worker_.start(0, [&](std::size_t) {
    for (const auto& run : runs) {
      record({without_faults(run.scenario), twin_folder(run.folder)}, true);
      mark_complete(twin_folder(run.folder));
    }
  });
}

void Twins::await() {
  worker_.reap([](std::size_t, const std::string& complaint) {
    if (!complaint.empty()) {
      throw run_failed("the day without faults: " + complaint);
    }
  });
}

}  // namespace evbal
