#include "experiments/study/design/study_file.hpp"

#include "common/installation.hpp"

#include <algorithm>
#include <cctype>

namespace evbal {

std::filesystem::path find_study(const std::filesystem::path& given) {
  return find_shipped("studies", given);
}

std::string shown(const YamlValue& value) {
  return value.is_scalar() ? value.text() : value.dump();
}

std::string plain_name(const YamlValue& value) {
  std::string name = value.file_name();
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), plain)) {
    throw value.error("`" + name + "` is no name; write letters, digits, `-`, `_` and `.` only");
  }
  return name;
}

std::vector<YamlValue> distinct_items(const YamlValue& list) {
  std::set<std::string> seen;
  for (const auto& item : list.items()) {
    if (!seen.insert(shown(item)).second) {
      throw item.error("`" + shown(item) + "` is given twice");
    }
  }
  if (seen.empty()) {
    throw list.error("holds nothing; give at least one");
  }
  return list.items();
}

std::vector<std::uint64_t> read_seeds(const YamlValue& list) {
  std::vector<std::uint64_t> seeds;
  for (const auto& item : distinct_items(list)) {
    seeds.push_back(item.seed());
  }
  return seeds;
}

}  // namespace evbal
