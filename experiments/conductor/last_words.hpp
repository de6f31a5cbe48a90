#pragma once

#include <filesystem>
#include <string>

namespace evbal {

/// The last lines of what a process printed into its log, for a message: ": line | line | line"; empty if there are
/// none.
std::string last_words(const std::filesystem::path& log);

}  // namespace evbal
