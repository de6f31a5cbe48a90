#include "experiments/study/executors/play_sweep.hpp"

#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "common/workers.hpp"
#include "experiments/record/summary.hpp"
#include "experiments/run/record_day.hpp"
#include "experiments/study/executors/play_days.hpp"
#include "experiments/study/executors/slurm.hpp"
#include "experiments/study/store/sweep_file.hpp"

#include <string>
#include <utility>
#include <vector>

namespace evbal {

namespace fs = std::filesystem;

SweepFolder::SweepFolder(fs::path folder) : folder_(std::move(folder)) {
  if (fs::exists(folder_) && !fs::exists(file()) && !(fs::is_directory(folder_) && fs::is_empty(folder_))) {
    throw bad_input("--out: " + folder_.string() + " is there and holds no sweep; give a new one");
  }
  fs::create_directories(folder_);
  lock_.emplace(folder_);
  if (!lock_->held()) {
    throw bad_input(folder_.string() + ": another evbal is at work there; wait for it or give another --out");
  }
}

std::vector<std::string> keys_of(const Sweep& sweep) {
  std::vector<std::string> keys;
  for (const auto& day : sweep.days) {
    const Scenario scenario = scenario_of(day);
    if (!scenario.planning.coordinator.empty()) {
      throw bad_input("coordinator `" + shown(scenario.planning.coordinator) +
                      "`: takes part over the bus, without which sweeps play their days; use `evbal run`");
    }
    keys.push_back(text_digest(resolved_yaml(scenario, day.controller)));
    check_interrupt();
  }
  return keys;
}

void play_sweep(const Sweep& sweep, const std::vector<std::string>& keys, const SweepFolder& folder,
                const Playing& playing) {
  const fs::path file = folder.file();
  const fs::path tasks = folder.path() / "slurm";
  const auto merge = [&](const fs::path& result) { merge_result(file, result); };
  if (fs::exists(tasks)) {
    begin_results(file);
    merge_left(tasks, merge);
  }
  const auto play = [&](std::size_t i) {
    const Scenario scenario = scenario_of(sweep.days[i]);
    add_result(file, keys[i], scenario.world.clock, play_day(scenario));
  };
  const auto task = [&](std::size_t i) {
    return SlurmTask{keys[i], resolved_yaml(scenario_of(sweep.days[i]), sweep.days[i].controller)};
  };
  const auto work = [&](const std::vector<std::size_t>& days, const Done& done) {
    if (playing.executor == "slurm") {
      work_on_slurm(days, {tasks, playing.jobs, task, merge}, done);
    } else {
      work_through(days, playing.jobs > 0 ? playing.jobs : cores(), play, done);
    }
  };
  const std::string failed = do_days(sweep, keys, file, playing.quiet, work);
  if (!failed.empty()) {
    throw run_failed("days that failed, to be played by the same command again:" + failed);
  }
  fs::remove_all(tasks);
}

}  // namespace evbal
