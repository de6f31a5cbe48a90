#pragma once

#include "experiments/study/design/variant_settings.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// What `evbal tune` freezes: a controller and its settings, for each scenario and variant (docs/tuning.md).
namespace evbal {

/// One tuned variant.
struct TunedVariant {
  ChosenController controller;    ///< who plans
  std::vector<Setting> settings;  ///< in place of the scenario's
};

/// By (scenario, variant).
using Tuned = std::map<std::pair<std::string, std::string>, TunedVariant>;

/// Reads what tuned_yaml wrote. Throws Error{bad_input}.
Tuned read_tuned(const std::filesystem::path& file);

/// The same as YAML.
std::string tuned_yaml(const Tuned& tuned);

}  // namespace evbal
