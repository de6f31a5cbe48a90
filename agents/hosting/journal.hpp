#pragma once

#include "common/open_file.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// A file of entries, each durable once it is appended: what a process must still know after it was killed.
class Journal {
 public:
  /// Opens the file, or makes it. An entry that was being written when its process died is cut off. Throws
  /// Error{run_failed} if the file cannot be opened or read, or if an entry is not what was appended, naming its place.
  explicit Journal(std::filesystem::path file);

  /// The entries that were there when the file was opened.
  const std::vector<std::string>& entries() const { return entries_; }

  /// On return the entry is on the disk. Throws Error{run_failed} if it cannot be written.
  void append(const std::string& entry);

 private:
  std::string whole_text() const;
  void take_entries(std::string_view text);

  std::filesystem::path path_;
  OpenFile file_;
  std::vector<std::string> entries_;
};

}  // namespace evbal
