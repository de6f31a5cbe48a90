#pragma once

#include "common/yaml.hpp"
#include "experiments/scenario/scenario.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Many days of one scenario, which differ in who controls, day, seed, faults and settings (docs/sweeps.md).
namespace evbal {

/// One day of a sweep.
struct SweptDay {
  std::string variant{};
  std::string controller{};
  std::string faults;  ///< name of the schedule; empty: the scenario's own
  std::string day;
  std::uint64_t seed = 0;
  std::map<std::string, std::string> settings{};  ///< of the variant, by path
  YamlValue yaml;                                 ///< the scenario with all of these, but for the controller
};

struct Sweep {
  std::vector<std::string> settings;  ///< paths that any variant sets, in the order of the file
  std::vector<SweptDay>
      days;  ///< at least one; by variant, its settings, faults, day and seed, in the order of the file
};

/// Reads a sweep. A schedule that leaves something open is drawn anew for every (day, seed), the same for all
/// variants. Throws Error{bad_input} with file, line, reason and what would be right; what a setting's value must be
/// is not looked at before scenario_of.
Sweep read_sweep(const std::filesystem::path& file);

/// The day's scenario: one controller, one process, nothing expected. Throws Error{bad_input}.
Scenario scenario_of(const SweptDay& day);

}  // namespace evbal
