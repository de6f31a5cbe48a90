#pragma once

#include <string>

namespace evbal {

/// The version of evbal that runs, "0.2.0": that of project() in CMakeLists.txt.
std::string version();

}  // namespace evbal
