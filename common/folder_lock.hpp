#pragma once

#include "common/open_file.hpp"

#include <filesystem>

namespace evbal {

/// A folder held by one process at a time. The kernel lets go of it when the process ends, however it does, and no file
/// is left.
class FolderLock {
 public:
  /// Tries to hold the folder. Throws Error{run_failed} if it cannot be opened, or if its file system has no locks.
  explicit FolderLock(const std::filesystem::path& folder);

  /// Whether it is held here; else another process holds it.
  bool held() const { return held_; }

 private:
  OpenFile folder_;
  bool held_ = false;
};

}  // namespace evbal
