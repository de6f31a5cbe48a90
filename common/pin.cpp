#include "common/pin.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace evbal {

void pin_arithmetic(char** argv) {
  const auto is_set = [](const auto& variable) {
    const char* value = std::getenv(variable.first);
    return value != nullptr && std::string_view(value) == variable.second;
  };
  if (std::all_of(pinned_environment.begin(), pinned_environment.end(), is_set)) {
    return;
  }
  for (const auto& [name, value] : pinned_environment) {
    setenv(name, value, 1);
  }
  std::error_code no_proc;
  execv(std::filesystem::read_symlink("/proc/self/exe", no_proc).c_str(), argv);
  // Without /proc the program goes on unpinned: right on this machine, perhaps not to the byte on another.
}

}  // namespace evbal
