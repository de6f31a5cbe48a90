#pragma once

#include <filesystem>
#include <string>

namespace evbal {

/// What a sweep is made from, kept in its sweep.sqlite (table `origin`) for those who read its results.
struct SweepOrigin {
  std::string command;   ///< that makes it again, but for --out
  std::string file;      ///< as given there
  std::string text;      ///< of that file
  std::string scenario;  ///< the first day's, resolved
};

/// Writes it into a sweep.sqlite in place of what stood there.
void note_origin(const std::filesystem::path& file, const SweepOrigin& origin);

/// Throws Error{bad_input} if the file does not say.
SweepOrigin read_origin(const std::filesystem::path& file);

}  // namespace evbal
