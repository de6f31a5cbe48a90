#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// A program and its first words; empty: no command.
using Command = std::vector<std::string>;

/// `words` with a program that has a slash, and every further word that names a file, as absolute paths; relative ones
/// start at `base`. A program without a slash is left to be found when it is started.
Command command_from(const std::filesystem::path& base, Command words);

/// The text as one word of a shell's.
std::string shell_word(const std::string& text);

/// The words in one line, for messages.
std::string shown(const Command& command);

}  // namespace evbal
