#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// Under which name the bound of a sweep's day is kept (bound_key in experiments/bound/bound_file.hpp).
struct BoundKey {
  std::string scenario;  ///< its name in the sweep
  std::string faults;    ///< name of the schedule
  /// ISO 8601.
  std::string day;
  std::uint64_t seed = 0;  ///< of the run
  std::string key;         ///< empty: variants play different days, for which no one bound holds
};

/// Writes them into a sweep.sqlite (table `bound_keys`) in place of what stood there.
void note_bound_keys(const std::filesystem::path& file, const std::vector<BoundKey>& keys);

/// Reads them back. Throws Error{bad_input} if the file does not have them.
std::vector<BoundKey> read_bound_keys(const std::filesystem::path& file);

}  // namespace evbal
