// The part of DdsPlayers that starts the processes.

#include "agents/bus/keys.hpp"
#include "agents/bus/ports.hpp"
#include "agents/hosting/journal.hpp"
#include "agents/hosting/journal_entries.hpp"
#include "agents/hosting/process.hpp"
#include "agents/region/region_world.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
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

// Fast DDS 2.9 keeps the words of at most 100 proofs in a process, those of peers that died a moment ago among them,
// and ends the process beyond.
constexpr int most_secured_agents = 80;

constexpr auto profiles_file = "dds-profiles.xml";  // on another host

/// The number of "agent-3".
int number_of_agent(const std::string& name) {
  return std::stoi(name.substr(name.find('-') + 1));
}

std::string world_file(int agent) {
  return "agent-" + std::to_string(agent) + ".world";
}

/// On another host.
std::string keys_folder(const std::string& agent) {
  return agent + ".keys";
}

}  // namespace

void DdsPlayers::make_keys(const BusAddress& address) {
  if (run_.security) {
    if (run_.agents() > most_secured_agents) {
      throw bad_input("security: at most " + std::to_string(most_secured_agents) +
                      " agents can prove themselves, here " + std::to_string(run_.agents()) +
                      " have to; host several regions by each, with regions_per_process at least " +
                      std::to_string((run_.regions + most_secured_agents - 1) / most_secured_agents));
    }
    const auto& ca = run_.security->ca;
    keys_.emplace(run_.folder / "keys");
    write_keys(keys_->path(), address,
               ca.empty() ? CertificateAuthority::made("evbal run " + address.run) : CertificateAuthority::read(ca));
  }
}

std::filesystem::path DdsPlayers::keys_of(int participant) const {
  return keys_ ? keys_->path() / name_of(participant) : "";
}

std::filesystem::path DdsPlayers::world_of(int agent) const {
  return run_.world == nullptr ? "" : journals_.path() / world_file(agent);
}

void DdsPlayers::write_agent_worlds() const {
  if (run_.world != nullptr) {
    const auto regions = region_worlds(*run_.world);
    for (int agent = 0; agent < run_.agents(); ++agent) {
      write_agent_world(world_of(agent), *run_.world, regions, run_.first_region(agent), run_.last_region(agent));
    }
  }
}

OtherHosts DdsPlayers::connect_hosts() const {
  OtherHosts others{.hosts = {}, .files_of = [this](const std::string& agent) { return files_of(agent); }};
  const HostFolders folders{.programs = run_.programs, .logs = run_.folder / "processes", .legs = journals_.path()};
  std::filesystem::create_directories(folders.logs);
  for (std::size_t i = 0; i < run_.hosts.size(); ++i) {
    others.hosts.push_back(std::make_unique<KeptHost>(run_.hosts[i], static_cast<int>(i), folders));
  }
  for (const auto& host : others.hosts) {
    host->await(run_.patience);
  }
  return others;
}

std::vector<SentFile> DdsPlayers::files_of(const std::string& agent) const {
  const int number = number_of_agent(agent);
  const RegionRange own{run_.first_region(number), run_.last_region(number)};
  std::vector<SentFile> files;
  if (run_.world != nullptr) {
    files.push_back({world_file(number), text_of_file(world_of(number))});
  }
  if (!run_.profiles.empty()) {
    files.push_back({profiles_file, text_of_file(run_.profiles)});
  }
  if (keys_) {
    for (const auto& entry : std::filesystem::directory_iterator(keys_->path() / agent)) {
      files.push_back({keys_folder(agent) + "/" + entry.path().filename().string(), text_of_file(entry.path())});
    }
  }
  std::string journal;
  for (const auto& [tick, plan] : told_) {
    // Also of the tick that goes on, which would be over before the agent is back if it had answered already.
    const bool all_said = plan || !waits_for_plan(tick, own);
    if (all_said && std::ranges::find(tick.due, own.first) != tick.due.end()) {
      journal += journal_text(to_bytes(agent_entry(tick, plan ? &*plan : nullptr, own)));
    }
  }
  if (!journal.empty()) {
    files.push_back({agent, std::move(journal)});
  }
  return files;
}

/// Why an agent cannot have its ports on another host; asked while none of the agents has them.
std::string DdsPlayers::complaint_of_hosts() const {
  const int first = discovery_port(domain_->domain(), BusAddress::first_agent);
  const int last = discovery_port(domain_->domain(), run_.participants()) - 1;
  std::string complaint;
  for (const auto& host : connect_hosts().hosts) {
    complaint += host->complaint_of_ports(first, last);
  }
  return complaint;
}

void DdsPlayers::start_processes(BusAddress address) {
  const std::size_t most_starting = most_starting_a_core * std::max(1U, std::thread::hardware_concurrency());
  const auto told = [&](ProcessOptions options) {
    check_interrupt();
    await_hellos(most_starting);
    options.address = address;
    options.address.keys = keys_of(address.participant);
    options.scenario = run_.folder / "scenario.resolved.yaml";
    options.journal = journals_.path() / options.name;
    options.patience = processes_patience * run_.patience;
    options.log_level = least_logged();
    return options;
  };
  const auto start = [&](const ProcessOptions& options, const std::vector<std::string>& command) {
    std::vector<std::string> words(command.begin() + 1, command.end());
    const auto more = arguments(options);
    words.insert(words.end(), more.begin(), more.end());
    const int host = address.participant - BusAddress::first_agent + 1;
    supervisor_->start(options.name, command.front(), words, network_ && host > 0 ? network_->namespace_of(host) : -1);
    absent_.insert(options.name);
  };
  const auto own = [&](const char* program) { return std::vector{(run_.programs / program).string()}; };
  address.participant = BusAddress::coordinator;
  start(told({.name = "coordinator"}), run_.coordinator.empty() ? own("evbal-coordinator") : run_.coordinator);
  address.participant = BusAddress::injector;
  start(told({.name = "faults"}), own("evbal-faults"));
  const std::vector<int> host_of_agent = share_out(run_.hosts, run_.agents());
  for (int agent = 0; agent < run_.agents(); ++agent) {
    address.participant = BusAddress::first_agent + agent;
    ProcessOptions options = told({.name = name_of(address.participant),
                                   .world = world_of(agent),
                                   .first_region = run_.first_region(agent),
                                   .last_region = run_.last_region(agent)});
    if (run_.hosts.empty()) {
      start(options, own("evbal-agent"));
      continue;
    }
    options.address.host = BusAddress{}.host;  // which its keeper says
    options.journal = options.name;
    options.world = options.world.filename();
    options.address.profiles = run_.profiles.empty() ? "" : profiles_file;
    options.address.keys = keys_ ? keys_folder(options.name) : "";
    supervisor_->start_there(options.name, host_of_agent[agent], arguments(options));
    absent_.insert(options.name);
  }
}

}  // namespace evbal
