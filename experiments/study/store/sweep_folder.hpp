#pragma once

#include "common/folder_lock.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace evbal {

/// What the files for the days are called in it (sweep_file.hpp).
inline constexpr const char* sweep_file_name = "sweep.sqlite";
/// The file of a tuning's days.
inline constexpr const char* tuning_file_name = "tuning.sqlite";
/// What a tuning froze, written at its end.
inline constexpr const char* tuned_file_name = "tuned.yaml";
/// The file of a search's days.
inline constexpr const char* search_file_name = "search.sqlite";

/// The folder that `evbal sweep`, `evbal tune` or `evbal search` writes into, held by one process at a time. A sweep
/// and the tuning that it needs first share it: each has a file of its own for its days.
class SweepFolder {
 public:
  /// Made if it is missing. `file` is one of the names above. Throws Error{bad_input} if the folder holds
  /// something else than a sweep, a tuning or a search, or if another process has it.
  SweepFolder(std::filesystem::path folder, const std::string& file);

  /// The folder.
  const std::filesystem::path& path() const { return folder_; }

  /// The file of the days, with its folder.
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path folder_;
  std::filesystem::path file_;
  std::optional<FolderLock> lock_;
};

}  // namespace evbal
