#pragma once

#include <filesystem>

namespace evbal {

/// A folder that is empty to begin with and goes with its owner.
class EmptyFolder {
 public:
  /// Makes the folder, or empties it; the object's end removes it.
  explicit EmptyFolder(std::filesystem::path path);
  ~EmptyFolder();
  EmptyFolder(const EmptyFolder&) = delete;
  EmptyFolder& operator=(const EmptyFolder&) = delete;

  /// Where it is.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace evbal
