#pragma once

#include "common/yaml.hpp"

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

/// What the files of sweeps and of tunings have in common: where they are, their lists and their names.
namespace evbal {

/// The file that a command line names: a path, or the name of one that is shipped, such as sweep-small.yaml.
std::filesystem::path find_study(const std::filesystem::path& given);

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
