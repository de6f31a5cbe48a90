#pragma once

#include <filesystem>
#include <string>

namespace evbal {

/// Where a process stands on the bus of a run. Its UDP ports follow from domain and participant (RTPS, section 9.6.1),
/// so no two processes of a host may share both.
struct BusAddress {
  static constexpr int conductor = 0;    ///< participants
  static constexpr int coordinator = 1;  ///< likewise
  static constexpr int injector = 2;     ///< likewise
  static constexpr int first_agent = 3;  ///< likewise; the other agents follow

  std::string run;  ///< id in every message; samples of other runs are dropped
  /// DDS domain of the run.
  int domain = 0;
  int participant = 0;                 ///< number of this process in the domain
  int participants = 0;                ///< of the whole run
  bool returns = false;                ///< the process has died and was started again; the others are there
  bool apart = false;                  ///< each agent on a host of its own, behind a network that may lose packets
  std::string host = "127.0.0.1";      ///< IPv4 address of this process's host; unless apart
  std::string launcher = "127.0.0.1";  ///< of the host of conductor, coordinator and injector; unless apart
  std::filesystem::path profiles{};    ///< XML file of Fast DDS whose defaults hold where evbal sets nothing; or empty
  std::filesystem::path keys{};        ///< by which this process proves who it is (keys.hpp); empty: nobody has to
  int regions_per_process = 1;         ///< that each agent hosts, in the order of their numbers

  /// The participant that hosts a region; -1 for a number that is none.
  int agent_of(int region) const { return region < 0 ? -1 : first_agent + region / regions_per_process; }
};

/// As the run's processes are called: "conductor", "coordinator", "faults", "agent-0" and so on.
std::string name_of(int participant);

/// IPv4 address of a host of such a network: 0 is that of all but the agents, then one for each agent.
std::string address_of_host(int host);

}  // namespace evbal
