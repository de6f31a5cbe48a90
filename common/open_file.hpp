#pragma once

#include <filesystem>

namespace evbal {

/// A file or folder that this process has open, under its number; no program that it starts inherits it unasked.
class OpenFile {
 public:
  /// `flags` as open(2) has them; a new file may be read by all. Throws Error{run_failed} saying why it cannot be
  /// opened.
  OpenFile(const std::filesystem::path& path, int flags);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// The file descriptor.
  int number() const { return number_; }

 private:
  int number_;
};

}  // namespace evbal
