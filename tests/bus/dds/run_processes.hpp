#pragma once

#include <sys/types.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace evbal::test {

/// The words of a process's command line; none if it has ended.
inline std::vector<std::string> command_line(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/cmdline");
  std::vector<std::string> words;
  for (std::string word; std::getline(in, word, '\0');) {
    words.push_back(word);
  }
  return words;
}

/// The word after `option` on the command line of a process; empty if there is none.
inline std::string word_after(pid_t process, const std::string& option) {
  const std::vector<std::string> words = command_line(process);
  const auto found = std::find(words.begin(), words.end(), option);
  return found == words.end() || found + 1 == words.end() ? "" : *(found + 1);
}

/// The process of the run in `folder` that has this name; 0 if there is none at the moment.
inline pid_t find_process(const std::string& folder, const std::string& name) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const pid_t id = std::atoi(entry.path().filename().c_str());
    const std::vector<std::string> words = id > 0 ? command_line(id) : std::vector<std::string>{};
    const auto option = std::find(words.begin(), words.end(), "--name");
    const bool of_run = std::any_of(words.begin(), words.end(),
                                    [&](const std::string& word) { return word.find(folder) != std::string::npos; });
    if (of_run && option != words.end() && option + 1 != words.end() && *(option + 1) == name) {
      return id;
    }
  }
  return 0;
}

}  // namespace evbal::test
