#pragma once

#include "common/command.hpp"
#include "experiments/study/design/bound_wish.hpp"
#include "experiments/study/design/variant_settings.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Frozen examinations (docs/leaderboard.md): the days on which any controller is held against the same reference.
namespace evbal {

/// The names of the two variants of a benchmark's sweeps.
inline constexpr const char* reference_variant = "reference";
/// Whoever is examined.
inline constexpr const char* entry_variant = "entry";

/// What a controller is set to, and what is searched for it on training days.
struct EntrySettings {
  std::vector<Setting> settings;      ///< as in a sweep's variant
  std::optional<YamlValue> search{};  ///< as in a tuning's variant; none: nothing is tuned
  std::vector<Setting> factors;       ///< lists of factors of what is set or tuned, which make a front
};

/// One city of a benchmark.
struct BenchmarkPart {
  std::string name;                ///< that no other part has
  std::filesystem::path scenario;  ///< absolute
  YamlValue days;                  ///< list, of the test
  YamlValue seeds;                 ///< list, of the test
  YamlValue faults;                ///< map, as in a sweep
  YamlValue reference;             ///< map of `controller` and `settings`
  YamlValue training;              ///< map of `days`, `seeds` and `faults`
  BoundWish bound{};               ///< of the days of the test; without prices none
};

/// A benchmark.
struct Benchmark {
  std::string name;                              ///< with its number, such as toy-1
  std::string digest;                            ///< fingerprint of its file and of its scenarios
  YamlValue objective;                           ///< map, as in a tuning
  int candidates = 0;                            ///< that are tried for an entry in each part
  std::vector<BenchmarkPart> parts;              ///< in the order of the file
  std::map<std::string, EntrySettings> entries;  ///< of controllers that it knows, by name
};

/// Reads a benchmark. Throws Error{bad_input} with file, line, reason and what would be right.
Benchmark read_benchmark(const std::filesystem::path& file);

/// Reads the map of an entry's `settings`, `search` and `factors`. Throws Error{bad_input}.
EntrySettings read_entry_settings(const YamlValue& value);

/// Whoever is examined.
struct Entry {
  std::string controller;    ///< its name
  Command coordinator{};     ///< program that plans in place of evbal's; empty: none
  EntrySettings settings{};  ///< of the controller
};

/// The tuning of an entry in a part, as a file for read_tuning; the variant is called as entry_variant.
std::string tuning_yaml(const Benchmark& benchmark, const BenchmarkPart& part, const Entry& entry);

/// The settings with which an entry is examined, YAML: its own, those that were tuned in their place or beside them,
/// and each list of factors multiplied. Throws Error{bad_input} if factors are of what is neither set nor tuned.
std::string examined_settings(const EntrySettings& entry, const std::vector<Setting>& tuned);

/// The sweep of a part, as a file for read_sweep: the reference, then the entry with these settings.
std::string sweep_yaml(const BenchmarkPart& part, const Entry& entry, const std::string& settings);

}  // namespace evbal
