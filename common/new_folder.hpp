#pragma once

#include <filesystem>

namespace evbal {

/// A folder that appears complete or not at all: files are written to path(), beside its place, until keep().
class NewFolder {
 public:
  /// Throws Error{bad_input} if `folder` exists and is not an empty folder, Error{run_failed} if none can be made
  /// there.
  explicit NewFolder(const std::filesystem::path& folder);

  /// Removes what was not kept.
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  /// Where to write meanwhile.
  const std::filesystem::path& path() const { return partial_; }

  /// Puts the folder in its place. Throws Error{run_failed}.
  void keep();

 private:
  std::filesystem::path target_;
  std::filesystem::path partial_;
};

}  // namespace evbal
