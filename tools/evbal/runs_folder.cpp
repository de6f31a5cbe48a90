#include "tools/evbal/runs_folder.hpp"

#include <unistd.h>

#include <string>

namespace evbal {

namespace fs = std::filesystem;

fs::path claim_folder(const Scenario& scenario) {
  const std::string controller = scenario.controllers.size() == 1 ? "-" + scenario.controllers.front() : "";
  const std::string base =
      scenario.name + "-" + scenario.world.day.date + controller + "-seed" + std::to_string(scenario.world.seed);
  fs::create_directories("runs");
  for (int number = 1;; ++number) {
    fs::path folder = fs::path("runs") / (number == 1 ? base : base + "-" + std::to_string(number));
    if (fs::create_directory(folder)) {
      return folder;
    }
  }
}

fs::path bounds_folder() {
  return fs::path("runs") / "bounds";
}

void name_latest(const fs::path& folder) {
  const fs::path latest = folder.parent_path() / "latest";
  const fs::path made = folder.parent_path() / (".latest-" + std::to_string(getpid()));
  std::error_code failed;
  if (fs::exists(fs::symlink_status(latest, failed)) && !fs::is_symlink(latest, failed)) {
    return;
  }
  fs::create_directory_symlink(folder.filename(), made, failed);
  if (!failed) {
    fs::rename(made, latest, failed);  // at once: another run may do the same
  }
  if (failed) {
    std::error_code kept;
    fs::remove(made, kept);
  }
}

}  // namespace evbal
