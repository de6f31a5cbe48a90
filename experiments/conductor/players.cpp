#include "experiments/conductor/players.hpp"

#include "common/error.hpp"

namespace evbal {

void Players::kill(const std::string& name) {
  std::string names;
  for (const PlayerProcess& process : processes()) {
    names += (names.empty() ? "" : ", ") + process.name;
  }
  throw bad_input("`" + name + "` is no process of this run that can be killed; " +
                  (names.empty() ? "all of it is in one process" : "its processes are " + names));
}

}  // namespace evbal
