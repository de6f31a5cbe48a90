#pragma once

#include "common/yaml.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// What the days of a sweep share, whoever controls: scenarios, faults, days and seeds (docs/sweeps.md).
namespace evbal {

/// A scenario, day, seed and schedule of faults.
struct Replication {
  std::string scenario;  ///< its name in the file
  std::string faults;    ///< name of the schedule; empty: the scenario's own
  std::string day;
  std::uint64_t seed = 0;
  YamlValue yaml;  ///< the scenario with all of these
};

/// The keys `scenario` or `scenarios`, `days`, `seeds` and `faults` of a file, read.
class Replications {
 public:
  /// Throws Error{bad_input} with file, line, reason and what would be right.
  explicit Replications(YamlMap& map);

  std::vector<std::string> scenarios() const;  ///< names, in the order of the file

  /// Those of one of `scenarios`, by faults, day and seed, in the order of the file; with `own_seeds`, if there are
  /// any, in place of the file's. A schedule that leaves something open is drawn anew for every (day, seed).
  std::vector<Replication> of(const std::string& scenario, const std::vector<std::uint64_t>& own_seeds = {}) const;

  /// Keeps so many of the first days and seeds.
  void cut(std::size_t days, std::size_t seeds);

 private:
  struct Scenario {
    std::string name;
    YamlValue yaml;
  };
  struct Faults {
    std::string name;
    std::optional<YamlValue> schedule;  ///< none: the scenario's own, if it has any
  };

  static std::vector<Scenario> read_scenarios(YamlMap& map);
  static std::vector<Faults> read_faults(const std::optional<YamlValue>& value);

  std::vector<Scenario> scenarios_;
  std::vector<Faults> faults_;
  std::vector<YamlValue> days_;
  std::vector<std::uint64_t> seeds_;
};

/// The items of a list. Throws Error{bad_input} if there is none or one is given twice.
std::vector<YamlValue> distinct_items(const YamlValue& list);

/// The variants of `list`, each as `read` gives it; no two may have the same `name`. Throws Error{bad_input}.
template <class Read>
auto read_variants(const YamlValue& list, const Read& read) {
  std::vector<decltype(read(list))> variants;
  std::set<std::string> names;
  for (const auto& item : distinct_items(list)) {
    variants.push_back(read(item));
    if (!names.insert(variants.back().name).second) {
      throw item.error("variant `" + variants.back().name + "` is given twice; give this one another `name`");
    }
  }
  return variants;
}

/// Seeds, all different. Throws Error{bad_input}.
std::vector<std::uint64_t> read_seeds(const YamlValue& list);

/// What a list item or a setting is called: its text, or its YAML.
std::string shown(const YamlValue& value);

/// A name in files and on the command line. Throws Error{bad_input}.
std::string plain_name(const YamlValue& value);

}  // namespace evbal
