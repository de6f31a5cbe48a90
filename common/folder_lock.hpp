#pragma once

#include <filesystem>

namespace evbal {

/// A directory held by one process at a time. The kernel lets go of it when the process dies, however it does, and no
/// file is left.
class FolderLock {
 public:
  /// Tries to hold the directory, which exists.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Whether it is held, and by nobody else.
  bool held() const { return file_ >= 0; }

 private:
  int file_ = -1;
};

}  // namespace evbal
