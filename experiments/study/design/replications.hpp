#pragma once

#include "common/yaml.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What the days of a sweep share, whoever controls: scenarios, faults, days and seeds (docs/sweeps.md).
namespace evbal {

/// A scenario, day, seed and schedule of faults.
struct PlannedReplication {
  std::string scenario;  ///< its name in the file
  std::string faults;    ///< name of the schedule; empty: the scenario's own
  /// ISO 8601.
  std::string day;
  std::uint64_t seed = 0;  ///< of the run
  YamlValue yaml;          ///< the scenario with all of these
};

/// The keys `scenario` or `scenarios`, `days`, `seeds` and `faults` of a file, read. A scenario of several may have
/// days and settings of its own.
class Replications {
 public:
  /// Throws Error{bad_input} with file, line, reason and what would be right.
  explicit Replications(YamlMap& map);

  std::vector<std::string> scenarios() const;  ///< names, in the order of the file

  /// The name of that scenario whose tuned settings one of `scenarios` takes in place of its own, if the file says so.
  const std::optional<YamlValue>& tuned_as(const std::string& scenario) const;

  /// Days of one of `scenarios`, in the order of the file.
  const std::vector<YamlValue>& days_of(const std::string& scenario) const;

  std::vector<std::string> faults() const;  ///< names of the schedules, in the order of the file

  /// Those of one of `scenarios`, by faults, day and seed, in the order of the file; with `own_seeds`, if there are
  /// any, in place of the file's. A schedule that leaves something open is drawn anew for every (day, seed).
  std::vector<PlannedReplication> of(const std::string& scenario,
                                     const std::vector<std::uint64_t>& own_seeds = {}) const;

  /// Keeps so many of the first days of each scenario, and of the seeds.
  void cut(std::size_t days, std::size_t seeds);

 private:
  struct Scenario {
    std::string name;
    YamlValue yaml;
    std::vector<YamlValue> days;
    std::optional<YamlValue> tuned_as;
  };
  struct Faults {
    std::string name;
    std::optional<YamlValue> schedule;  ///< none: the scenario's own, if it has any
  };

  static Scenario read_scenario_of(const std::string& name, const YamlValue& value,
                                   const std::optional<YamlValue>& days);
  static std::vector<Scenario> read_scenarios(YamlMap& map);
  const Scenario& scenario(const std::string& name) const;
  static std::vector<Faults> read_faults(const std::optional<YamlValue>& value);

  std::vector<Scenario> scenarios_;
  std::vector<Faults> faults_;
  std::vector<std::uint64_t> seeds_;
};

}  // namespace evbal
