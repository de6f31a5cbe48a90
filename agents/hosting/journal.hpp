#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// A file of entries, each durable once it is appended: what a process must still know after it was killed.
class Journal {
 public:
  /// Opens the file, or makes it. An entry that was being written when its process died is cut off. Throws
  /// Error{run_failed} if the file cannot be used, or if an entry is not what was once appended.
  explicit Journal(std::filesystem::path file);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// The entries that were there when the file was opened.
  const std::vector<std::string>& entries() const { return entries_; }

  /// On return the entry is on the disk. Throws Error{run_failed} if it cannot be written.
  void append(const std::string& entry);

 private:
  void read_all();

  std::filesystem::path path_;
  int file_ = -1;
  std::vector<std::string> entries_;
};

}  // namespace evbal
