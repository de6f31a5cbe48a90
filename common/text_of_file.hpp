#pragma once

#include <filesystem>
#include <string>

namespace evbal {

/// A whole file, empty if it cannot be read.
std::string text_of_file(const std::filesystem::path& file);

}  // namespace evbal
