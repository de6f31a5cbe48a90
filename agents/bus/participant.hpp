#pragma once

#include "agents/bus/bus_address.hpp"
#include "agents/bus/hello.hpp"
#include "agents/protocol/messages.hpp"
#include "agents/protocol/region_range.hpp"

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace eprosima::fastdds::dds {
class DataReader;
class DataWriter;
}  // namespace eprosima::fastdds::dds

namespace evbal {

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

  /// Sleeps until the readers that are connected have confirmed all that was written, or the time is up.
  void wait_until_heard(std::chrono::milliseconds at_most);

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

template <class Message>
class Inbox;

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

  /// What was refused since the last call, in a few words, and how often.
  std::map<std::string, int> refused();

  /// Sleeps until there are so many messages to take, or the time is up.
  void wait(std::chrono::milliseconds at_most, std::size_t messages = 1) const;

  /// Writers that are connected now.
  int writers() const;

 private:
  Inbox<Message>* inbox_;
  eprosima::fastdds::dds::DataReader* reader_;
};

}  // namespace evbal
