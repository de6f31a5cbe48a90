#include "experiments/run/twins.hpp"

#include "common/error.hpp"
#include "experiments/record/paired_run.hpp"

#include <unistd.h>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// Whether a day was recorded there to its end.
bool is_finished(const fs::path& folder) {
  return fs::exists(folder / "summary.json") && !fs::exists(folder / "INCOMPLETE");
}

}  // namespace

std::vector<Run> runs_of(const Scenario& scenario, const std::filesystem::path& folder) {
  std::vector<Run> runs;
  runs.reserve(scenario.controllers.size());
  for (const auto& controller : scenario.controllers) {
    runs.push_back(
        {with_controller(scenario, controller), scenario.controllers.size() == 1 ? folder : folder / controller});
  }
  return runs;
}

RunResult record(const Run& run, const std::function<void(const TickRecord&)>& on_tick,
                 const std::optional<DoorOptions>& door) {
  const Scenario& scenario = run.scenario;
  return record_day(scenario, resolved_yaml(scenario, scenario.planning.controller), run.folder,
                    {.transport = scenario.transport, .on_tick = on_tick, .door = door});
}

Twins::Twins(const std::vector<Run>& runs) {
  worker_.start(0, [&](std::size_t) {
    needed_.close_write_end();
    std::size_t position = 0;
    while (read(needed_.read_end(), &position, sizeof position) == sizeof position) {
      const Run& run = runs[position];
      const fs::path folder = twin_folder(run.folder);
      if (!is_finished(folder)) {
        fs::remove_all(folder);
        record({without_faults(run.scenario), folder});
        mark_complete(folder);
      }
    }
  });
}

void Twins::need(std::size_t run) {
  if (asked_.insert(run).second && write(needed_.write_end(), &run, sizeof run) != sizeof run) {
    throw run_failed("the process that plays the day without faults is gone");
  }
}

void Twins::await() {
  needed_.close_write_end();
  worker_.reap([](std::size_t, const std::string& complaint) {
    if (!complaint.empty()) {
      throw run_failed("the day without faults: " + complaint);
    }
  });
}

}  // namespace evbal
