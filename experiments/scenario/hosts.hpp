#pragma once

#include "common/command.hpp"
#include "common/yaml.hpp"
#include "common/yaml_writer.hpp"

#include <string>
#include <vector>

/// The machines that host a day's regions (docs/hosts.md): the key `hosts` of a scenario. Conductor, coordinator and
/// injector stay on the machine where the run was started.
namespace evbal {

/// One of them.
struct HostSpec {
  std::string address;  ///< IPv4, under which the run's other machines reach it
  Command start{};      ///< `ssh` or `srun`, and the words that tell it which host; empty: the launcher's own machine
  int weight = 1;       ///< the share of the regions that it hosts is weight / sum of weights

  /// Field by field.
  bool operator==(const HostSpec&) const = default;
};

/// Reads a list of `{address: 10.0.0.2, start: ssh b, weight: 2}`. `start` is `local`, or `ssh` or `srun` and the words
/// that such a program needs to know the host by; `weight` may be left out. Throws Error{bad_input} with file and line.
std::vector<HostSpec> read_hosts(const YamlValue& list);

/// Writes the same list: read_hosts gives it back.
void write_hosts(YamlWriter& yaml, const std::vector<HostSpec>& hosts);

/// "10.0.0.2 (ssh b)": for messages.
std::string shown(const HostSpec& host);

/// Their addresses.
std::vector<std::string> addresses(const std::vector<HostSpec>& hosts);

/// The command that has a shell on the host do what `script`, one line, says.
Command on_host(const HostSpec& host, const std::string& script);

/// The position in `hosts` of the host of each of so many agents; empty without hosts. Neighbours share a host; one of
/// small weight may get none.
std::vector<int> share_out(const std::vector<HostSpec>& hosts, int agents);

/// The regions that each host holds, ascending, where an agent hosts `regions_per_process` of the city's `regions`.
std::vector<std::vector<int>> regions_by_host(const std::vector<HostSpec>& hosts, int regions, int regions_per_process);

}  // namespace evbal
