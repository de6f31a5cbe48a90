#include "experiments/conductor/supervisor.hpp"

#include "agents/hosting/process.hpp"
#include "common/contract.hpp"
#include "common/error.hpp"
#include "common/open_file.hpp"
#include "common/spawn.hpp"
#include "experiments/conductor/last_words.hpp"
#include "experiments/conductor/lossy_network.hpp"

#include <fcntl.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

namespace evbal {
namespace {

using namespace std::chrono_literals;

constexpr int most_deaths = 5;  // of one process without progress of the run

/// The process of that name, which exists.
auto& named(auto& processes, const std::string& name) {
  const auto found = std::find_if(processes.begin(), processes.end(), [&](const auto& p) { return p.name == name; });
  EVBAL_EXPECT(found != processes.end(), "the name of a process");
  return *found;
}

}  // namespace

Supervisor::Supervisor(std::filesystem::path log_folder, OtherHosts others)
    : log_folder_(std::move(log_folder)), others_(std::move(others)) {
  std::filesystem::create_directories(log_folder_);
}

Supervisor::~Supervisor() {
  for (const auto& host : others_.hosts) {
    host->end();
  }
  std::erase_if(processes_, [](const Process& process) { return process.host != here; });
  pipe_.close_write_end();
  for (const auto& process : processes_) {
    if (process.id != 0) {
      ::kill(process.id, SIGCONT);  // who stands still cannot see the pipe close
    }
  }
  const auto deadline = std::chrono::steady_clock::now() + time_for_farewell;
  for (reap_ended(); any_left() && std::chrono::steady_clock::now() < deadline; reap_ended()) {
    std::this_thread::sleep_for(5ms);
  }
  for (const auto& process : processes_) {
    if (process.id != 0) {
      ::kill(process.id, SIGKILL);
    }
  }
  for (const auto& process : processes_) {
    if (process.id != 0) {
      waitpid(process.id, nullptr, 0);
    }
  }
}

void Supervisor::reap_ended() {
  for (auto& process : processes_) {
    if (process.id != 0 && waitpid(process.id, nullptr, WNOHANG) == process.id) {
      process.id = 0;
    }
  }
}

bool Supervisor::any_left() const {
  return std::ranges::any_of(processes_, [](const Process& process) { return process.id != 0; });
}

void Supervisor::start(const std::string& name, const std::filesystem::path& program,
                       const std::vector<std::string>& arguments, int network) {
  Process process{.name = name, .command = {program.string()}, .network = network};
  process.command.insert(process.command.end(), arguments.begin(), arguments.end());
  spawn(process);
  processes_.push_back(std::move(process));
}

void Supervisor::start_there(const std::string& name, int host, const std::vector<std::string>& arguments) {
  Process process{.name = name, .command = arguments, .host = host};
  spawn(process);
  processes_.push_back(std::move(process));
}

void Supervisor::spawn(Process& process) {
  if (process.host != here) {
    spawn_there(process);
    return;
  }
  const OpenFile log(log_folder_ / (process.name + ".log"), O_WRONLY | O_CREAT | O_APPEND);
  const InNamespace network(process.network);
  process.id =
      evbal::spawn(process.command, {.input = pipe_.read_end(), .output = log.number(), .errors = log.number()});
}

/// On its host, or on another one if that is gone.
void Supervisor::spawn_there(Process& process) {
  const std::vector<SentFile> files = others_.files_of(process.name);
  for (;; process.host = best_host()) {
    if (const auto id = others_.hosts[process.host]->start(process.name, process.command, files)) {
      process.id = *id;
      return;
    }
  }
}

/// Of the hosts that are there the one that hosts least for its weight.
int Supervisor::best_host() const {
  int best = here;
  double least = 0.0;
  std::string why;
  for (int host = 0; host < static_cast<int>(others_.hosts.size()); ++host) {
    KeptHost& other = *others_.hosts[host];
    const auto hosted = std::ranges::count(processes_, host, &Process::host);
    const double load = static_cast<double>(hosted + 1) / other.spec().weight;
    if (const std::string gone = other.gone(); !gone.empty()) {
      why += (why.empty() ? "" : "; ") + shown(other.spec()) + ": " + gone;
    } else if (best == here || load < least) {
      best = host;
      least = load;
    }
  }
  if (best == here) {
    throw run_failed("no host is left: " + why);
  }
  return best;
}

std::vector<Death> Supervisor::revive() {
  std::vector<Death> deaths;
  for (auto& process : processes_) {
    int status = 0;
    if (process.host == here && process.id != 0 && waitpid(process.id, &status, WNOHANG) == process.id) {
      note_death(process, status, deaths);
    }
  }
  revive_there(deaths);
  return deaths;
}

/// Starts the process again, unless it would only die again.
void Supervisor::note_death(Process& process, int status, std::vector<Death>& deaths) {
  const std::string how = "process " + std::to_string(std::exchange(process.id, 0)) + " " + ending(status);
  if (!ended_from_outside(status)) {
    throw run_failed(process.name + ": " + how + last_words(process.name));
  }
  if (++process.deaths > most_deaths) {
    throw run_failed(process.name + ": " + how + ", the last of " + std::to_string(process.deaths) +
                     " deaths in a row" + last_words(process.name));
  }
  spawn(process);
  deaths.push_back({process.name, how});
}

void Supervisor::revive_there(std::vector<Death>& deaths) {
  for (int host = 0; host < static_cast<int>(others_.hosts.size()); ++host) {
    for (const HostNews& news : others_.hosts[host]->ended()) {
      Process& process = find(news.process);
      if (process.host == host && process.id == news.number) {  // not one that the run itself has killed
        note_death(process, std::stoi(news.text), deaths);
      }
    }
    if (const std::string why = others_.hosts[host]->gone(); !why.empty() && left_.insert(host).second) {
      leave(host, why, deaths);
    }
  }
}

/// Starts what was on a host that is gone on others.
void Supervisor::leave(int host, const std::string& why, std::vector<Death>& deaths) {
  hosts_gone_.push_back(shown(others_.hosts[host]->spec()) + ": " + why);
  for (Process& process : processes_) {
    if (process.host == host && process.id != 0) {
      process.id = 0;
      spawn(process);
      deaths.push_back({process.name, "its host is gone, it goes on on " + shown(others_.hosts[process.host]->spec())});
    }
  }
}

void Supervisor::send_signal(const Process& process, int number) {
  if (process.host != here) {
    others_.hosts[process.host]->send_signal(process.name, number);
  } else {
    ::kill(process.id, number);
  }
}

void Supervisor::kill(const std::string& name) {
  Process& process = find(name);
  if (process.id != 0) {
    send_signal(process, SIGKILL);
    const pid_t id = std::exchange(process.id, 0);
    if (process.host == here) {
      waitpid(id, nullptr, 0);
    }
  }
}

void Supervisor::start_again(const std::string& name) {
  spawn(find(name));
}

void Supervisor::stop(const std::string& name) {
  send_signal(find(name), SIGSTOP);
}

void Supervisor::go_on(const std::string& name) {
  send_signal(find(name), SIGCONT);
}

void Supervisor::progress() {
  for (auto& process : processes_) {
    process.deaths = 0;
  }
}

pid_t Supervisor::process_id(const std::string& name) const {
  return named(processes_, name).id;
}

Supervisor::Process& Supervisor::find(const std::string& name) {
  return named(processes_, name);
}

std::string Supervisor::last_words(const std::string& name) const {
  return evbal::last_words(log_folder_ / (name + ".log"));
}

}  // namespace evbal
