#pragma once

#include "experiments/study/design/variant_settings.hpp"

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What `evbal tune` freezes: a controller and its settings, for each scenario and variant (docs/tuning.md).
namespace evbal {

/// By how much the chosen settings were better than others that were tried, by the objective: a mean over replications
/// that both played, with its 95 % interval over days, which is infinite where it is not known.
struct TunedGain {
  int replications = 0;                                   ///< that both played; 0: there are no others
  double mean = 0.0;                                      ///< others' objective less the chosen ones'
  double low = -std::numeric_limits<double>::infinity();  ///< lower end
  double high = std::numeric_limits<double>::infinity();  ///< upper end
};

/// What the search for a variant's settings spent and found.
struct TuningOutcome {
  int tried = 0;                     ///< settings
  int days = 0;                      ///< that they played in all
  double objective = 0.0;            ///< of the chosen settings, mean over all replications
  TunedGain over_second{};           ///< over the second best, on all replications
  TunedGain over_first_round{};      ///< over what was best after the first round
  std::vector<std::string> edges{};  ///< values at an edge of what was searched (edges_of)

  /// By how much the second best may be better than the chosen settings: as far as the interval of `over_second` goes
  /// below 0; infinite where it is not known, 0 if there is no second.
  double regret() const;
};

/// One tuned variant.
struct TunedVariant {
  ChosenController controller;             ///< who plans
  std::vector<Setting> settings;           ///< in place of the scenario's
  std::optional<TuningOutcome> outcome{};  ///< none if the file does not say
};

/// By (scenario, variant).
using Tuned = std::map<std::pair<std::string, std::string>, TunedVariant>;

/// Reads what tuned_yaml wrote. Throws Error{bad_input}.
Tuned read_tuned(const std::filesystem::path& file);

/// The same as YAML.
std::string tuned_yaml(const Tuned& tuned);

}  // namespace evbal
