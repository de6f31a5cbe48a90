#pragma once

#include "common/open_file.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// A file of entries: what a process must still know after it was killed. The operating system keeps what was
/// appended, however the process ends; nothing is kept for a machine that loses power, after which no run goes on.
class Journal {
 public:
  /// Opens the file, or makes it. An entry that was being written when its process died is cut off. Throws
  /// Error{run_failed} if the file cannot be opened or read, or if an entry is not what was appended, naming its place.
  explicit Journal(std::filesystem::path file);

  /// The entries that were there when the file was opened.
  const std::vector<std::string>& entries() const { return entries_; }

  /// On return the operating system has the entry. Throws Error{run_failed} if it cannot be written.
  void append(const std::string& entry);

 private:
  std::string whole_text() const;
  void take_entries(std::string_view text);

  std::filesystem::path path_;
  OpenFile file_;
  std::vector<std::string> entries_;
};

/// The text of a journal with this entry alone; texts of one entry after another are that of a journal with all of
/// them.
std::string journal_text(const std::string& entry);

}  // namespace evbal
