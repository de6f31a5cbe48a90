#include "experiments/conductor/last_words.hpp"

#include <deque>
#include <fstream>

namespace evbal {

std::string last_words(const std::filesystem::path& file) {
  std::ifstream log(file);
  std::deque<std::string> last;
  for (std::string line; std::getline(log, line);) {
    if (line.find_first_not_of(" \t") != std::string::npos) {
      last.push_back(line);
    }
    if (last.size() > 3) {
      last.pop_front();
    }
  }
  std::string words;
  for (const auto& line : last) {
    words += (words.empty() ? ": " : " | ") + line;
  }
  return words;
}

}  // namespace evbal
