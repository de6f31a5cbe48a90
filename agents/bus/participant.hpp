#pragma once

#include "agents/bus/hello.hpp"
#include "agents/protocol/messages.hpp"
#include "agents/protocol/region_range.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace eprosima::fastdds::dds {
class DataReader;
class DataWriter;
}  // namespace eprosima::fastdds::dds

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

/// One process on the bus: UDPv4, on the interface of its host's address alone, no shared memory, and nothing of the
/// surroundings (surroundings.hpp) but the profiles that the address names. Agents look for the conductor and the
/// coordinator alone and nobody looks for agents, so that discovery stays linear in their number. All calls from one
/// thread.
class Participant {
 public:
  /// Throws Error{run_failed} if the middleware refuses, as it does keys that are not right, or cannot have the
  /// address's ports, Error{bad_input} if it cannot read the profiles.
  Participant(const BusAddress& address, const std::string& name);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// Sleeps until one of its writers or readers has found, or lost, another one since the last call, or the time is up.
  void wait_for_match(std::chrono::milliseconds at_most) const;

  /// Whom the bus has kept out since the last call, in a few words each; nobody where nobody has to prove who he is.
  std::vector<std::string> strangers();

  /// Where it stands on the bus.
  const BusAddress& address() const { return address_; }

 private:
  template <class Message>
  friend class Writer;
  template <class Message>
  friend class Reader;
  struct Entities;

  BusAddress address_;
  std::unique_ptr<Entities> entities_;
};

/// This process's end of a topic. Messages: Hello, Faults, Tick, std::vector<Report>, Plan, std::vector<Departures>;
/// evbal.idl says who sends what to whom. Lives no longer than its participant.
template <class Message>
class Writer {
 public:
  /// `participant` must outlive this. Throws Error{run_failed} if the middleware refuses.
  explicit Writer(Participant& participant);

  /// Hands the message to the middleware, which delivers it reliably. Throws Error{run_failed} if it refuses.
  void write(const Message& message);

  /// Readers that are connected now.
  int readers() const;

 private:
  std::string run_;
  eprosima::fastdds::dds::DataWriter* writer_;
};

/// A message and the number of the participant that wrote it.
template <class Message>
struct Heard {
  int from = 0;     ///< participant that wrote it
  Message message;  ///< as it was written
};

/// Believes those who have a say on its topic, by the participant's number, as far as they speak for themselves, and
/// refuses everything else: an agent has no say for regions that another one hosts.
template <class Message>
class Reader {
 public:
  /// Of the lists in a message only what concerns `regions` is kept. `participant` must outlive this. Throws
  /// Error{run_failed} if the middleware refuses.
  explicit Reader(Participant& participant, const RegionRange& regions = {});

  /// All that has come since the last call, in the order of each writer. Throws Error{run_failed} if one who has a say
  /// wrote what is no message.
  std::vector<Heard<Message>> take();

  /// What take() has refused since the last call, in a few words, and how often.
  std::map<std::string, int> refused();

  /// Sleeps until there is something to take or the time is up.
  void wait(std::chrono::milliseconds at_most) const;

  /// Writers that are connected now.
  int writers() const;

 private:
  const Participant& participant_;
  RegionRange regions_;
  eprosima::fastdds::dds::DataReader* reader_;
  std::map<std::string, int> refused_;
};

}  // namespace evbal
