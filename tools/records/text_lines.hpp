#pragma once

#include "common/error.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace evbal {

/// The lines of a text file, plain or compressed (.gz, .xz, .bz2, .zst), read as a stream: memory does not grow with
/// the file. UTF-8 with or without a byte order mark; lines end in LF, CR LF, or CR alone. Throws Error{bad_input} with
/// file and line if the file is missing, cannot be unpacked, is truncated, UTF-16 or a zip archive.
class LineReader {
 public:
  /// A file with a line of more than `longest` bytes is refused, since it is hardly text.
  explicit LineReader(const std::filesystem::path& file, std::size_t longest = SIZE_MAX);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// Puts the next line, without its end, into `line`; false at the end of the file.
  bool next(std::string& line);

  /// An error at the current line.
  Error error(const std::string& message) const;

  /// The file that is read.
  const std::string& file() const { return file_; }

  /// The number of the current line, from 1.
  int line() const { return line_; }

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
  std::string file_;
  std::size_t longest_;
  int line_ = 0;
};

/// A whole file, plain or compressed, with LF at the end of each line. Throws as LineReader does, and if the text has
/// more than `longest` bytes: a small file may unpack to any size.
std::string unpacked_text(const std::filesystem::path& file, std::size_t longest = 1 << 28);

/// The file's name without the ending of a compression (.gz, .xz, .bz2, .zst, in any case).
std::filesystem::path without_packing(std::filesystem::path file);

/// The files of a folder that end in .csv, in any case, plain or compressed, by name. Throws Error{bad_input} if there
/// are none.
std::vector<std::filesystem::path> csv_files(const std::filesystem::path& folder);

/// The same with .txt as well.
std::vector<std::filesystem::path> text_files(const std::filesystem::path& folder);

}  // namespace evbal
