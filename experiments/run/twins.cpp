#include "experiments/run/twins.hpp"

#include "common/error.hpp"
#include "experiments/record/paired_run.hpp"

#include <fcntl.h>
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

DayTally with_tick(DayTally so_far, const TickRecord& tick) {
  so_far.tick = tick.tick.tick;
  so_far.waiting = so_far.vacant = so_far.queue = 0;
  for (const Departures& said : tick.exchange.departures) {
    for (const Fate& fate : said.fates) {
      ++(fate.served ? so_far.served : so_far.lost);
    }
    for (const Departure& departure : said.departures) {
      so_far.empty_km += departure.errand == Errand::passenger ? 0.0 : departure.km;
    }
    so_far.waiting += said.waiting;
    so_far.vacant += said.vacant;
    so_far.queue += said.low_battery;
  }
  return so_far;
}

Twins::Twins(const std::vector<Run>& runs) {
  fcntl(played_.read_end(), F_SETFL, O_NONBLOCK);
  fcntl(played_.write_end(), F_SETFL, O_NONBLOCK);  // who does not listen holds nobody up
  worker_.start(0, [&](std::size_t) {
    needed_.close_write_end();
    std::size_t position = 0;
    while (read(needed_.read_end(), &position, sizeof position) == sizeof position) {
      const Run& run = runs[position];
      const fs::path folder = twin_folder(run.folder);
      DayTally so_far{.run = static_cast<int>(position)};
      if (!is_finished(folder)) {
        fs::remove_all(folder);
        record({without_faults(run.scenario), folder}, [&](const TickRecord& tick) {
          so_far = with_tick(so_far, tick);
          [[maybe_unused]] const ssize_t told = write(played_.write_end(), &so_far, sizeof so_far);
        });
        mark_complete(folder);
      }
    }
  });
  played_.close_write_end();
}

void Twins::need(std::size_t run) {
  if (asked_.insert(run).second && write(needed_.write_end(), &run, sizeof run) != sizeof run) {
    throw run_failed("the process that plays the day without faults is gone");
  }
}

std::vector<DayTally> Twins::heard(std::size_t run) {
  std::vector<DayTally> ticks;
  for (DayTally tick; read(played_.read_end(), &tick, sizeof tick) == sizeof tick;) {
    if (tick.run == static_cast<int>(run)) {
      ticks.push_back(tick);
    }
  }
  return ticks;
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
