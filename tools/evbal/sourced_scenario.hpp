#pragma once

#include "common/yaml.hpp"
#include "experiments/scenario/scenario.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace evbal {

/// A resolved scenario, and where each of its values comes from: a place in a file such as `toy.yaml:8`, an option, the
/// city's pack, or a default.
struct SourcedScenario {
  YamlValue resolved;                                        ///< with everything explicit
  std::string text;                                          ///< the same as YAML, sources as comments
  std::vector<std::pair<std::string, std::string>> sources;  ///< by path, such as `balancing.tau`, in order
};

/// Resolves a scenario. Throws as read_scenario.
SourcedScenario sourced_scenario(const std::filesystem::path& file, const Overrides& overrides);

}  // namespace evbal
