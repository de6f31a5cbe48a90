#pragma once

#include "common/yaml.hpp"
#include "experiments/scenario/scenario.hpp"
#include "experiments/study/design/bound_wish.hpp"
#include "experiments/study/design/page.hpp"
#include "experiments/study/design/replications.hpp"
#include "experiments/study/design/variant_settings.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Many days, which differ in scenario, who controls, day, seed, faults and settings (docs/sweeps.md).
namespace evbal {

/// One day of a sweep.
struct SweptDay {
  std::string scenario{};    ///< its name in the sweep
  std::string variant{};     ///< its name
  std::string controller{};  ///< its name
  Command coordinator{};     ///< that plans in place of evbal's; empty: none
  std::string faults;        ///< name of the schedule; empty: the scenario's own
  /// ISO 8601.
  std::string day;
  std::uint64_t seed = 0;                         ///< of the run
  std::map<std::string, std::string> settings{};  ///< of the variant, by path
  YamlValue yaml;                                 ///< the scenario with all of these, but for who plans
};

/// The days of a sweep, and its page.
struct Sweep {
  std::vector<std::string> settings;  ///< paths that any variant sets, in the order of the file
  std::vector<SweptDay> days;  ///< at least one; by variant, scenario, settings, faults, day and seed, as in the file
  BoundWish bound{};           ///< of its days; without prices none
  std::optional<Page> page{};  ///< that it ends with
};

/// How much of a sweep is read, and what else it needs.
struct SweepReading {
  bool quick = false;             ///< two days, one seed, and two values of each setting only
  std::filesystem::path tuned{};  ///< what came of the file's `tuning`; empty: it has none
};

/// Reads a sweep. Throws Error{bad_input} with file, line, reason and what would be right; what a setting's value must
/// be is not looked at before scenario_of.
Sweep read_sweep(const std::filesystem::path& file, const SweepReading& reading = {});

/// The file with the tuning that a sweep needs first, by its key `tuning`; empty if it needs none.
std::filesystem::path tuning_of(const std::filesystem::path& file);

/// The days that are to be bounded, by position: the first of each scenario, day and seed among those without faults
/// and with one of the wish's seeds. Whoever controls, a day has the same bound.
std::vector<std::size_t> days_to_bound(const Sweep& sweep, const BoundWish& wish);

/// The day of a variant on a replication.
SweptDay day_of(const PlannedReplication& replication, const std::string& variant, const ChosenController& controller,
                const std::vector<Setting>& settings);

/// What a day is called in messages: its scenario, variant, settings, faults, date and seed.
std::string label_of(const SweptDay& day);

/// The day's scenario: one controller, one process, nothing expected. Throws Error{bad_input}.
Scenario scenario_of(const SweptDay& day);

}  // namespace evbal
