#pragma once

#include "agents/bus/participant.hpp"
#include "common/legs.hpp"
#include "common/log.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace evbal {

/// What the conductor tells a process that it starts.
struct ProcessOptions {
  std::string name;                  ///< "agent-0", "coordinator", "faults"
  BusAddress address{};              ///< where the process stands on the bus
  std::filesystem::path scenario{};  ///< the run's scenario.resolved.yaml
  std::filesystem::path journal{};   ///< what the process knows if it is started again (journal.hpp)
  std::chrono::seconds patience{};   ///< longest wait for anything that another process says
  std::filesystem::path world{};     ///< of an agent: what it is told of its regions (agents/region/region_world.hpp)
  int first_region = 0;              ///< of an agent, which hosts first_region..last_region
  int last_region = 0;               ///< the last of them
  LogLevel log_level = LogLevel::warn;  ///< from which on the process logs
};

/// The options as arguments of a command line, which run_process reads.
std::vector<std::string> arguments(const ProcessOptions& options);

/// Times the legs of this process's ticks. What they took is written to legs_file() when the process ends with the
/// conductor.
Legs& process_legs();

/// Where a process with this journal writes what its legs took.
std::filesystem::path legs_file(const std::filesystem::path& journal);

/// What is in such a file; nothing if there is none.
std::vector<Leg> read_legs(const std::filesystem::path& file);

/// The main of every process on the bus: pins the arithmetic, reads the arguments, joins the bus, runs `body`, and
/// turns errors into a line on stderr and an exit status. The process ends when its standard input does, that is
/// with the conductor, or when `body` returns.
int run_process(int argc, char** argv, const std::string& description,
                const std::function<void(const ProcessOptions&, Participant&)>& body);

/// As long as the object lives, this process calls a function of ours before it ends because its standard input has
/// ended. It is called in another thread than main's, which goes on meanwhile; the conductor kills whoever takes longer
/// than `time_for_farewell`. There may be one such object at a time.
class Farewell {
 public:
  /// `say` is called.
  explicit Farewell(std::function<void()> say);
  ~Farewell();
  Farewell(const Farewell&) = delete;
  Farewell& operator=(const Farewell&) = delete;
};

/// How long the processes of a run may take, all together, to end once their standard input has ended.
constexpr std::chrono::seconds time_for_farewell{5};

}  // namespace evbal
