#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace evbal {

/// A whole file, empty if it cannot be read.
std::string text_of_file(const std::filesystem::path& file);

/// Writes a whole file or leaves what is there. Throws Error{run_failed} with the system's reason.
void write_file(const std::filesystem::path& file, std::string_view text);

/// A file that appears whole or not at all: text goes into a file of another name beside it, which takes its place with
/// keep(). Until then, and if keep() is never reached, a file that has the name already stays as it is. What is no
/// regular file, such as /dev/stdout, is written directly. All members throw Error{run_failed} with the system's
/// reason.
class NewFile {
 public:
  /// Nothing is written yet.
  explicit NewFile(const std::filesystem::path& file);

  /// Removes what was not kept.
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Adds text at the end.
  void write(std::string_view text);

  /// Puts the file in its place; nothing may be written after that.
  void keep();

 private:
  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };

  std::filesystem::path file_;
  std::filesystem::path partial_;  ///< where the text goes; empty if directly into file_
  std::unique_ptr<std::FILE, Close> stream_;
  bool kept_ = false;
};

}  // namespace evbal
