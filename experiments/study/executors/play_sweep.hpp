#pragma once

#include "common/folder_lock.hpp"
#include "experiments/study/design/sweep.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// How a sweep's days are played, none of which changes what comes of them.
struct Playing {
  int jobs = 0;  ///< days at a time; 0: one a core, or as many as Slurm likes
  bool quiet = false;
  std::string executor = "local";  ///< or "slurm"
};

/// The folder of a sweep, held by one process at a time.
class SweepFolder {
 public:
  /// Made if it is missing. Throws Error{bad_input} if it holds something else or another process has it.
  explicit SweepFolder(std::filesystem::path folder);

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path file() const { return folder_ / "sweep.sqlite"; }

 private:
  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;
};

/// A fingerprint of each day's resolved scenario. Throws Error{bad_input} if one is wrong.
std::vector<std::string> keys_of(const Sweep& sweep);

/// Plays the days that have no result in the folder yet. Throws Error{run_failed} if days failed.
void play_sweep(const Sweep& sweep, const std::vector<std::string>& keys, const SweepFolder& folder,
                const Playing& playing);

}  // namespace evbal
