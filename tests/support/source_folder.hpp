#pragma once

#include <filesystem>
#include <string>

namespace evbal::test {

/// A path of the source tree, from its root: "docs/faults.md".
std::filesystem::path in_source(const std::string& path);

}  // namespace evbal::test
