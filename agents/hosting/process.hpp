#pragma once

#include "agents/bus/participant.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// What the conductor tells a process that it starts.
struct ProcessOptions {
  std::string name;  ///< "agent-0", "coordinator", "faults"
  BusAddress address;
  std::filesystem::path scenario;  ///< the run's scenario.resolved.yaml
  std::filesystem::path journal;   ///< what the process knows if it is started again (common/journal.hpp)
  int first_region = 0;            ///< of an agent, which hosts first_region..last_region
  int last_region = 0;
};

/// The options as arguments of a command line, which run_process reads.
std::vector<std::string> arguments(const ProcessOptions& options);

/// The main of every process on the bus: pins the arithmetic, reads the arguments, joins the bus, runs `body`, and
/// turns errors into a line on stderr and an exit status. The process ends when its standard input does, that is
/// with the conductor, or when `body` returns.
int run_process(int argc, char** argv, const std::string& description,
                const std::function<void(const ProcessOptions&, Participant&)>& body);

}  // namespace evbal
