#pragma once

#include "experiments/study/executors/play_days.hpp"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// Days as tasks of Slurm job arrays (docs/sweeps.md). Folder and program are to be where every node sees them.
namespace evbal {

/// A day as a task of its own, known by a name that no other has.
struct SlurmTask {
  std::string name;      ///< of the job
  std::string scenario;  ///< resolved
};

/// Waits that long.
using Pause = std::function<void(std::chrono::milliseconds)>;

/// A Pause that throws Error{run_failed} if this program is asked to end.
void pause_unless_interrupted(std::chrono::milliseconds length);

/// Days as tasks of job arrays.
struct SlurmTasks {
  std::filesystem::path folder;                             ///< of the tasks' files, made if it is missing
  int at_a_time = 0;                                        ///< 0: as many as Slurm likes
  std::chrono::seconds task_limit{0};                       ///< after which Slurm ends a task; 0: the site's
  std::function<SlurmTask(std::size_t)> task;               ///< by position of the day
  std::function<void(const std::filesystem::path&)> merge;  ///< takes over a file of one result
  Pause pause = pause_unless_interrupted;                   ///< between looks
  std::size_t longest_array = 1000;  ///< Slurm's MaxArraySize, unless a site sets another, is 1001
};

/// After an evbal that was killed while its tasks ran: cancels the tasks in `folder`, waits for their end, takes over
/// what they have left and removes the folder. Throws Error{run_failed} if a task does not end.
void merge_left(const std::filesystem::path& folder, const std::function<void(const std::filesystem::path&)>& merge,
                const Pause& pause = pause_unless_interrupted);

/// Submits the days as job arrays, a day a task, and takes their results over as they come. `done` hears of each that
/// ends, with what went wrong or an empty text. Tasks that are left when this throws are cancelled. Throws
/// Error{run_failed} if Slurm does not take them.
void work_on_slurm(const std::vector<std::size_t>& days, const SlurmTasks& tasks, const Done& done);

/// Plays the day of a task and leaves its result beside the scenario's file, as `evbal slurm-task` does.
void play_slurm_task(const std::filesystem::path& scenario_file);

}  // namespace evbal
