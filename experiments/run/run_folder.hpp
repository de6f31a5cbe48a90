#pragma once

#include "common/folder_lock.hpp"

#include <filesystem>
#include <optional>

namespace evbal {

/// The directory that `evbal run` writes into. Held as long as the object lives, and no longer than the process does,
/// however it ends: so a run that goes on is told from one that broke off.
class OutFolder {
 public:
  /// Makes the directory, or takes an empty one, or one whose run broke off, of which everything is removed. Throws
  /// Error{bad_input} if it has anything else in it, or if a run goes on there.
  explicit OutFolder(std::filesystem::path folder);

  const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;
};

/// Whether a run was recorded there, broke off, and goes on no more.
bool broke_off(const std::filesystem::path& folder);

}  // namespace evbal
