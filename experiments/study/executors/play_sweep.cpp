#include "experiments/study/executors/play_sweep.hpp"

#include "common/error.hpp"
#include "common/workers.hpp"
#include "experiments/study/executors/play_into.hpp"
#include "experiments/study/executors/slurm.hpp"
#include "experiments/study/store/sweep_file.hpp"

#include <filesystem>

namespace evbal {

namespace fs = std::filesystem;

std::vector<FailedDay> play_sweep(const Sweep& sweep, const std::vector<std::string>& keys, const SweepFolder& folder,
                                  const Playing& playing) {
  const fs::path& file = folder.file();
  const fs::path tasks = fs::path(file).replace_extension(".slurm");
  const auto merge = [&](const fs::path& result) { merge_result(file, result); };
  if (fs::exists(tasks)) {
    begin_results(file);
    merge_left(tasks, merge);
  }
  const auto play = [&](std::size_t i) {
    const Scenario scenario = scenario_of(sweep.days[i]);
    play_into(file, keys[i], scenario);
  };
  const auto task = [&](std::size_t i) {
    return SlurmTask{keys[i], resolved_yaml(scenario_of(sweep.days[i]), sweep.days[i].controller)};
  };
  const auto work = [&](const std::vector<std::size_t>& days, const Done& done) {
    if (playing.executor == "slurm") {
      work_on_slurm(
          days,
          {.folder = tasks, .at_a_time = playing.jobs, .task_limit = playing.day_limit, .task = task, .merge = merge},
          done);
    } else {
      work_through(days, playing.jobs > 0 ? playing.jobs : cores(), play, done, playing.day_limit);
    }
  };
  std::vector<FailedDay> failed = do_days(sweep, keys, file, playing.on_day_ended, work);
  if (failed.empty()) {
    fs::remove_all(tasks);
  }
  return failed;
}

void refuse_failed(const std::vector<FailedDay>& failed, const Sweep& sweep) {
  if (!failed.empty()) {
    throw run_failed(std::to_string(failed.size()) + " of " + std::to_string(sweep.days.size()) +
                     " days failed twice; the same command tries them again:" + shown(failed));
  }
}

}  // namespace evbal
