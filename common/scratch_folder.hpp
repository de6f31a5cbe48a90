#pragma once

#include <filesystem>

namespace evbal {

/// A new, empty folder with a name that nobody can guess; it goes with its owner.
class ScratchFolder {
 public:
  /// Throws Error{run_failed} if none can be made in `parent`.
  explicit ScratchFolder(const std::filesystem::path& parent = std::filesystem::temp_directory_path());
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// The folder.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace evbal
