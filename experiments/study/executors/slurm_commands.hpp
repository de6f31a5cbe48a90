#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

/// What this program asks of Slurm, by the programs sbatch, squeue and scancel, the first of each name in $PATH.
namespace evbal {

/// A job array to be submitted: `tasks` runs of a script, which each know their number, from 1 on.
struct JobArray {
  std::filesystem::path script;  ///< that Slurm runs for each task
  std::filesystem::path folder;  ///< in which tasks run; each leaves what it prints there, in ID-NUMBER.log
  std::size_t tasks = 0;         ///< of the array
  int at_a_time = 0;             ///< tasks that may run at a time; 0: as many as Slurm likes
  std::chrono::seconds limit{};  ///< after which a task is ended, in whole minutes as Slurm counts; 0: the site's
  std::string after{};           ///< id of an array that must end before this one begins; empty: none
};

/// Submits the array and gives its id. Throws Error{run_failed} if Slurm does not take it, or does not say its id.
std::string submit(const JobArray& array);

/// The ids of this user's arrays of which tasks wait, run or are being ended in `folder`; nothing if Slurm does not say
/// now.
std::optional<std::set<std::string>> arrays_in(const std::filesystem::path& folder);

/// Asks Slurm to end the arrays with these ids. Whether it does is not known before arrays_in no longer names them.
void cancel(const std::set<std::string>& ids);

}  // namespace evbal
