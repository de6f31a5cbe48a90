#include "agents/bus/surroundings.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {
namespace {

bool is_for_fast_dds(std::string_view variable) {
  static constexpr std::array<std::string_view, 3> ros = {"ROS_DISCOVERY_SERVER", "ROS_SUPER_CLIENT", "ROS2_EASY_MODE"};
  return variable.starts_with("FASTDDS_") || variable.starts_with("FASTRTPS_") ||
         std::ranges::find(ros, variable) != ros.end();
}

}  // namespace

void ignore_surroundings() {
  std::vector<std::string> found;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view whole = *entry;
    if (const auto name = whole.substr(0, whole.find('=')); is_for_fast_dds(name)) {
      found.emplace_back(name);
    }
  }
  for (const auto& name : found) {
    unsetenv(name.c_str());
  }
  constexpr auto no_default_profiles = "SKIP_DEFAULT_XML_FILE";
  const char* value = std::getenv(no_default_profiles);
  if (value == nullptr || std::string_view(value) != "1") {
    setenv(no_default_profiles, "1", 1);
  }
}

}  // namespace evbal
