#include "experiments/scenario/input_digests.hpp"

#include "common/digest.hpp"
#include "common/installation.hpp"

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
  std::string digests;
  for (const auto& word : coordinator) {
    const fs::path program = digests.empty() ? find_program(word) : fs::path();
    const fs::path file = program.empty() ? fs::path(word) : program;
    std::error_code unreadable;
    digests += (fs::is_regular_file(file, unreadable) ? file_digest(file) : "-") + "\n";
  }
  return digests.empty() ? "" : text_digest(digests);
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
