#pragma once

#include "coordinator/balancing/controllers.hpp"

#include <string>
#include <vector>

namespace evbal {

/// All controllers but those that follow a rule.
inline std::vector<std::string> solving_controllers() {
  auto names = controller_names();
  std::erase(names, "none");
  std::erase(names, "greedy");
  return names;
}

}  // namespace evbal
