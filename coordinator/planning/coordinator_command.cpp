#include "coordinator/planning/coordinator_command.hpp"

#include "common/error.hpp"
#include "common/installation.hpp"

namespace evbal {
namespace {

namespace fs = std::filesystem;

const std::string bridge_program = "evbal-bridge";

}  // namespace

Command own_words(Command coordinator) {
  if (!coordinator.empty() && fs::path(coordinator.front()).filename() == bridge_program) {
    coordinator.erase(coordinator.begin());
  }
  return coordinator;
}

bool is_library(const Command& own_words) {
  return !own_words.empty() && fs::path(own_words.front()).extension() == ".so";
}

Command on_the_bus(Command coordinator) {
  if (is_library(coordinator)) {
    coordinator.insert(coordinator.begin(), bridge_program);
  }
  return coordinator;
}

fs::path file_of(const Command& coordinator) {
  fs::path file = coordinator.empty() ? fs::path() : find_program(coordinator.front());
  std::error_code unreadable;
  if (file.empty() && is_library(coordinator) && fs::is_regular_file(coordinator.front(), unreadable)) {
    file = coordinator.front();
  }
  if (file.empty()) {
    throw bad_input("coordinator `" + shown(coordinator) + "`: there is no " +
                    (is_library(coordinator) ? "library" : "program") + " `" +
                    (coordinator.empty() ? "" : coordinator.front()) +
                    "`; give its path, or the name of one beside evbal or in $PATH");
  }
  return file;
}

}  // namespace evbal
