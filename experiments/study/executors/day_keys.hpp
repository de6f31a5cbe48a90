#pragma once

#include "experiments/scenario/scenario.hpp"
#include "experiments/study/design/sweep.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace evbal {

/// Gives days their keys. A key is a fingerprint of all that a day's result comes from: the resolved scenario, the
/// city pack, the model, a coordinator's files, and the version of evbal. Files are read once, and taken to stay as
/// they are.
class DayKeys {
 public:
  /// The key of a scenario under one controller. Throws Error{bad_input} if a file cannot be read.
  std::string of(const Scenario& scenario, const std::string& controller);

 private:
  std::map<std::filesystem::path, std::string> packs_;   ///< digests, by folder
  std::map<std::filesystem::path, std::string> models_;  ///< digests, by file
  std::map<Command, std::string> commands_;              ///< digests of coordinators
};

/// The key of each of the sweep's days. Throws Error{bad_input} if a scenario is wrong, Error{run_failed} if
/// interrupted.
std::vector<std::string> keys_of(const Sweep& sweep);

}  // namespace evbal
