#include "experiments/scenario/hosts.hpp"

#include <arpa/inet.h>

#include <cstdint>
#include <map>
#include <sstream>

namespace evbal {
namespace {

constexpr auto here = "local";
constexpr int most_weight = 1000;

/// The programs that reach a host, each with the options by which nobody is asked for a password and who does not
/// answer is given up.
const std::map<std::string, Command>& starters() {
  static const std::map<std::string, Command> all = {
      {"ssh", {"-T", "-o", "BatchMode=yes", "-o", "ConnectTimeout=10"}},
      {"srun", {"--nodes=1", "--ntasks=1", "--overlap", "--quiet"}},
  };
  return all;
}

Command read_start(const YamlValue& value) {
  std::istringstream text(value.text());
  Command words;
  for (std::string word; text >> word;) {
    words.push_back(word);
  }
  if (words == Command{here}) {
    return {};
  }
  if (words.size() < 2 || !starters().contains(words.front())) {
    throw value.error("`" + value.text() +
                      "` starts nothing on a host; give `local`, `ssh` and the name of a host, such as `ssh b`, or "
                      "`srun` and its options, such as `srun --nodelist=b`");
  }
  return words;
}

/// The words as the scenario has them.
std::string start_text(const HostSpec& host) {
  return host.start.empty() ? here : shown(host.start);
}

std::string read_address(const YamlValue& value) {
  in_addr parsed{};
  if (inet_pton(AF_INET, value.text().c_str(), &parsed) != 1 || parsed.s_addr == INADDR_ANY) {
    throw value.error("`" + value.text() +
                      "` is no IPv4 address; give the one by which the other hosts reach this "
                      "host, such as 10.0.0.2");
  }
  return value.text();
}

}  // namespace

std::vector<HostSpec> read_hosts(const YamlValue& list) {
  std::vector<HostSpec> hosts;
  for (const auto& item : list.items()) {
    YamlMap map(item);
    HostSpec host{.address = read_address(map.require("address")), .start = read_start(map.require("start"))};
    if (const auto weight = map.find("weight")) {
      host.weight = weight->integer(1, most_weight);
    }
    map.finish();
    hosts.push_back(std::move(host));
  }
  if (hosts.empty()) {
    throw list.error("names no host; give at least one, or leave `hosts` out");
  }
  return hosts;
}

void write_hosts(YamlWriter& yaml, const std::vector<HostSpec>& hosts) {
  yaml.begin_list();
  for (const auto& host : hosts) {
    yaml.begin_map(YamlWriter::Layout::one_line).key("address").text(host.address);
    yaml.key("start").text(start_text(host)).key("weight").number(host.weight).end_map();
  }
  yaml.end_list();
}

std::string shown(const HostSpec& host) {
  return host.address + " (" + start_text(host) + ")";
}

std::vector<std::string> addresses(const std::vector<HostSpec>& hosts) {
  std::vector<std::string> all;
  for (const auto& host : hosts) {
    all.push_back(host.address);
  }
  return all;
}

Command on_host(const HostSpec& host, const std::string& script) {
  Command command = host.start;
  if (!command.empty()) {
    const Command& options = starters().at(command.front());
    command.insert(command.begin() + 1, options.begin(), options.end());
  }
  if (!command.empty() && command.front() == "ssh") {
    command.push_back("sh -c " + shell_word(script));  // for the shell of whoever it logs in as
  } else {
    command.insert(command.end(), {"sh", "-c", script});
  }
  if (command.front() == "srun") {
    // Killed with its launcher it would have its step killed, which should end by itself.
    command.insert(command.begin(), {"sh", "-c", "\"$@\"; exit $?", "sh"});
  }
  return command;
}

std::vector<int> share_out(const std::vector<HostSpec>& hosts, int agents) {
  std::int64_t sum = 0;
  for (const auto& host : hosts) {
    sum += host.weight;
  }
  std::vector<int> host_of_agent;
  std::int64_t reached = 0;
  for (std::size_t i = 0; i < hosts.size(); ++i) {
    reached += hosts[i].weight;
    host_of_agent.resize(static_cast<std::size_t>((agents * reached + sum / 2) / sum), static_cast<int>(i));
  }
  return host_of_agent;
}

std::vector<std::vector<int>> regions_by_host(const std::vector<HostSpec>& hosts, int regions,
                                              int regions_per_process) {
  std::vector<std::vector<int>> by_host(hosts.size());
  const std::vector<int> host_of_agent = share_out(hosts, (regions + regions_per_process - 1) / regions_per_process);
  for (int region = 0; region < regions && !hosts.empty(); ++region) {
    by_host[host_of_agent[region / regions_per_process]].push_back(region);
  }
  return by_host;
}

}  // namespace evbal
