#include "experiments/scenario/input_digests.hpp"

#include "common/digest.hpp"
#include "coordinator/planning/coordinator_command.hpp"

#include <map>

namespace evbal {

namespace fs = std::filesystem;

InputDigests input_digests(const Scenario& scenario) {
  return {.pack = pack_digest(scenario.world.city.folder),
          .model = model_digest(model_file(scenario.planning, scenario.world.city)),
          .coordinator = command_digest(scenario.planning.coordinator)};
}

std::string model_digest(const fs::path& file) {
  return fs::exists(file) ? file_digest(file) : "";
}

std::string command_digest(const Command& coordinator) {
  if (coordinator.empty()) {
    return "";
  }
  const Command words = own_words(coordinator);
  std::string digests = file_digest(file_of(words)) + "\n";
  for (std::size_t i = 1; i < words.size(); ++i) {
    std::error_code unreadable;
    digests += (fs::is_regular_file(words[i], unreadable) ? file_digest(words[i]) : "-") + "\n";
  }
  return text_digest(digests);
}

std::string pack_digest(const fs::path& folder) {
  std::map<std::string, std::string> digests;  // by the file's name in the pack
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (entry.is_regular_file() && name != "README.md" && name != "model.json") {
      digests[entry.path().lexically_relative(folder).string()] = file_digest(entry.path());
    }
  }
  std::string text;
  for (const auto& [name, digest] : digests) {
    text.append(name).append(" ").append(digest).append("\n");
  }
  return text_digest(text);
}

}  // namespace evbal
