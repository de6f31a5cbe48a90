#pragma once

#include <string>

namespace evbal {

/// The version of evbal that runs, "0.2.0": that of project() in CMakeLists.txt.
std::string version();

/// The program that runs: its version and a fingerprint of its file, "evbal 0.2.0 (build 1f6d03c2)". Two builds of one
/// version differ in it.
std::string this_program();

}  // namespace evbal
