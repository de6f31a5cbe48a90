#include "common/command.hpp"

namespace evbal {

Command command_from(const std::filesystem::path& base, Command words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto path = base / words[i];
    std::error_code unreadable;
    if (i == 0 ? words[i].find('/') != std::string::npos : std::filesystem::is_regular_file(path, unreadable)) {
      words[i] = std::filesystem::absolute(path).lexically_normal().string();
    }
  }
  return words;
}

std::string shell_word(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' ? "'\\''" : std::string{c};
  }
  return result + "'";
}

std::string shown(const Command& command) {
  std::string text;
  for (const auto& word : command) {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

}  // namespace evbal
