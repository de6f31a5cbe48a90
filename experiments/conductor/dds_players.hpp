#pragma once

#include "agents/bus/participant.hpp"
#include "agents/world/world.hpp"
#include "common/installation.hpp"
#include "experiments/conductor/domain_lock.hpp"
#include "experiments/conductor/empty_folder.hpp"
#include "experiments/conductor/lossy_network.hpp"
#include "experiments/conductor/players.hpp"
#include "experiments/conductor/supervisor.hpp"
#include "experiments/scenario/bus_security.hpp"
#include "experiments/scenario/hosts.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace evbal {

/// What the processes of a run are started from.
struct DdsRun {
  /// The run directory: scenario.resolved.yaml is there, processes/ is made, and journals/ and, with security, keys/ as
  /// long as the run lasts.
  std::filesystem::path folder;
  int regions = 0;               ///< of the city
  int regions_per_process = 1;   ///< that one agent hosts
  const World* world = nullptr;  ///< of which each agent gets its regions' part; stand-ins for agents need none
  std::filesystem::path programs = own_folder();  ///< where evbal-agent, evbal-coordinator and evbal-faults are
  std::vector<std::string> coordinator{};         ///< program and first words in place of evbal-coordinator's
  std::chrono::seconds patience{120};             ///< longest wait for anything, the processes' start included
  std::optional<NetworkConditions> network{};     ///< between each agent and the others
  std::uint64_t seed = 0;                         ///< of what it loses
  std::filesystem::path profiles{};               ///< as in BusAddress
  std::vector<HostSpec> hosts{};                  ///< of the agents; none: this one. Not together with `network`
  std::optional<BusSecurity> security{};          ///< if processes have to prove that they belong to the run

  /// Processes that host regions.
  int agents() const { return (regions + regions_per_process - 1) / regions_per_process; }
  /// All processes, the conductor's included.
  int participants() const { return BusAddress::first_agent + agents(); }
  /// The first of the regions that an agent hosts.
  int first_region(int agent) const { return agent * regions_per_process; }
  /// The last of them.
  int last_region(int agent) const { return std::min(first_region(agent + 1), regions) - 1; }
};

/// The others as processes on the bus: starts them, waits until all are there, and ends them when destroyed. One that
/// a signal from outside ends meanwhile is started again and waited for. An agent whose host is gone goes on on another
/// one, from all that it was told before. What strangers say on the bus is refused and counted as an incident. Made
/// before anything else of this process touches DDS.
class DdsPlayers : public Players {
 public:
  /// Throws Error{run_failed} naming who did not come.
  explicit DdsPlayers(const DdsRun& run);
  ~DdsPlayers() override;

  Faults faults(int tick) override;
  Exchange play(const Tick& tick) override;
  int regions_per_process() const override { return run_.regions_per_process; }

  /// By signals: SIGKILL; SIGSTOP and SIGCONT.
  void take_away(const Absences& away) override;

  void amended(int fault) override;
  void stand_still() override;
  std::vector<PlayerProcess> processes() const override;
  void kill(const std::string& name) override;

  std::vector<ProcessLegs> end() override;

  /// Of "agent-0", ..., "coordinator" or "faults".
  pid_t process_id(const std::string& name) const { return supervisor_->process_id(name); }

  /// Wall seconds from the first start until all had said hello.
  double ready_seconds() const { return ready_seconds_; }

 private:
  struct Topics;

  /// Starts all and waits for them; false if another program has taken one of the domain's ports meanwhile.
  bool begins_in_domain();
  void make_keys(const BusAddress& address);
  std::filesystem::path keys_of(int participant) const;
  void write_agent_worlds() const;
  std::filesystem::path world_of(int agent) const;
  void start_processes(BusAddress address);

  /// Connects to the hosts of the run.
  OtherHosts connect_hosts() const;
  /// What an agent on another host needs there.
  std::vector<SentFile> files_of(const std::string& agent) const;
  std::string complaint_of_hosts() const;
  void await_hellos(std::size_t but = 0);
  void bring_back(const std::string& name, Absence how);
  std::string host_of(int region) const;

  /// Starts processes that died again, and takes the hellos of those that are back.
  void look_after_processes();
  void take_hellos();
  void say(const Tick& tick);

  /// Waits until `come`, which takes from `reader` and needs a message of all who are `missing`, `but` so many, is
  /// true; else names them.
  template <class Message>
  void await(const std::string& what, const Reader<Message>& reader, const std::function<bool()>& come,
             const std::function<std::set<std::string>()>& missing, std::size_t but = 0);

  DdsRun run_;
  EmptyFolder journals_;
  std::optional<EmptyFolder> keys_;  ///< with security
  std::optional<LossyNetwork> network_;
  std::optional<DomainLock> domain_;
  std::optional<Participant> participant_;
  std::unique_ptr<Topics> topics_;
  std::optional<Supervisor>
      supervisor_;                ///< ends the processes before we leave the bus, which takes long among hundreds
  std::set<std::string> absent_;  ///< from whom no hello has come since the start, or since its death
  std::map<std::string, std::chrono::steady_clock::time_point> deaths_;  ///< when one of the absent died
  std::chrono::steady_clock::time_point looked_;                         ///< when the processes were looked after
  std::vector<Incident> incidents_;
  Absences away_;
  std::vector<std::pair<Tick, std::optional<Plan>>> told_;  ///< if agents are on other hosts
  int newest_ = -1;                                         ///< tick that was announced
  Tick said_;                                      ///< what was announced last; of number -1 before the first tick
  int newest_fault_ = -1;                          ///< that was added to the schedule and has not been said yet
  std::chrono::steady_clock::time_point said_at_;  ///< when it was last announced
  double ready_seconds_ = 0.0;
};

}  // namespace evbal
