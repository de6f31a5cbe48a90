#pragma once

#include "experiments/conductor/relay.hpp"
#include "experiments/scenario/network_conditions.hpp"

#include <optional>
#include <vector>

namespace evbal {

/// A network of a run's own: this process in one network namespace, and a further one for each host, each with a TUN
/// device and the address that the bus gives it (agents/bus/participant.hpp); between them a relay that loses packets.
/// Namespaces and devices have no name outside and are gone when the last process is that is in them, however it ends.
class LossyNetwork {
 public:
  /// Moves this thread, and so what it starts from now on, into the network. No other thread may run. Throws
  /// Error{bad_input} saying what is missing if namespaces are forbidden here.
  LossyNetwork(const NetworkConditions& conditions, int hosts, std::uint64_t seed);

  /// Moves this thread back, where that is allowed.
  ~LossyNetwork();
  LossyNetwork(const LossyNetwork&) = delete;
  LossyNetwork& operator=(const LossyNetwork&) = delete;

  /// The namespace of a host, from 1 on, as a file.
  int namespace_of(int host) const;

 private:
  void add_host();
  void close_all();

  int original_ = -1;
  std::vector<int> namespaces_;
  std::vector<TunEnd> ends_;
  std::optional<Relay> relay_;
};

/// This thread in another network namespace as long as the object lives; in its own if `file` is -1.
class InNamespace {
 public:
  /// Enters the namespace of this file descriptor. Throws Error{run_failed}.
  explicit InNamespace(int file);
  ~InNamespace();
  InNamespace(const InNamespace&) = delete;
  InNamespace& operator=(const InNamespace&) = delete;

 private:
  int own_ = -1;
};

}  // namespace evbal
