// The part of DdsPlayers that starts the processes.

#include "agents/hosting/process.hpp"
#include "agents/region/region_world.hpp"
#include "common/interrupt.hpp"
#include "common/log.hpp"
#include "experiments/conductor/collected.hpp"
#include "experiments/conductor/dds_players.hpp"

#include <algorithm>
#include <thread>

namespace evbal {
namespace {

// A process waits that many times longer than the conductor, who waits for the others one after another and can say
// who is missing.
constexpr int processes_patience = 10;

// That are started and have not said hello yet. More would make each other late, until nobody hears an answer in time.
constexpr std::size_t most_starting_a_core = 32;

}  // namespace

std::filesystem::path DdsPlayers::world_of(int agent) const {
  return run_.world == nullptr ? "" : journals_.path() / ("agent-" + std::to_string(agent) + ".world");
}

void DdsPlayers::write_agent_worlds() const {
  if (run_.world != nullptr) {
    const auto regions = region_worlds(*run_.world);
    for (int agent = 0; agent < run_.agents(); ++agent) {
      write_agent_world(world_of(agent), *run_.world, regions, run_.first_region(agent), run_.last_region(agent));
    }
  }
}

void DdsPlayers::start_processes(BusAddress address) {
  const std::size_t most_starting = most_starting_a_core * std::max(1U, std::thread::hardware_concurrency());
  const auto start = [&](ProcessOptions told, const std::vector<std::string>& command) {
    check_interrupt();
    await_hellos(most_starting);
    told.address = address;
    told.scenario = run_.folder / "scenario.resolved.yaml";
    told.journal = journals_.path() / told.name;
    told.patience = processes_patience * run_.patience;
    told.log_level = least_logged();
    std::vector<std::string> words(command.begin() + 1, command.end());
    const auto options = arguments(told);
    words.insert(words.end(), options.begin(), options.end());
    const int host = address.participant - BusAddress::first_agent + 1;
    supervisor_->start(told.name, command.front(), words, network_ && host > 0 ? network_->namespace_of(host) : -1);
    absent_.insert(told.name);
  };
  const auto own = [&](const char* program) { return std::vector{(run_.programs / program).string()}; };
  address.participant = BusAddress::coordinator;
  start({.name = "coordinator"}, run_.coordinator.empty() ? own("evbal-coordinator") : run_.coordinator);
  address.participant = BusAddress::injector;
  start({.name = "faults"}, own("evbal-faults"));
  for (int agent = 0; agent < run_.agents(); ++agent) {
    address.participant = BusAddress::first_agent + agent;
    start({.name = name_of(address.participant),
           .world = world_of(agent),
           .first_region = run_.first_region(agent),
           .last_region = run_.last_region(agent)},
          own("evbal-agent"));
  }
}

}  // namespace evbal
