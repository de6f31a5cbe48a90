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

Supervisor::Supervisor(std::filesystem::path log_folder) : log_folder_(std::move(log_folder)) {
  std::filesystem::create_directories(log_folder_);
}

Supervisor::~Supervisor() {
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

void Supervisor::spawn(Process& process) {
  const OpenFile log(log_folder_ / (process.name + ".log"), O_WRONLY | O_CREAT | O_APPEND);
  const InNamespace network(process.network);
  process.id =
      evbal::spawn(process.command, {.input = pipe_.read_end(), .output = log.number(), .errors = log.number()});
}

std::vector<Death> Supervisor::revive() {
  std::vector<Death> deaths;
  for (auto& process : processes_) {
    int status = 0;
    if (process.id == 0 || waitpid(process.id, &status, WNOHANG) != process.id) {
      continue;
    }
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
  return deaths;
}

void Supervisor::kill(const std::string& name) {
  Process& process = find(name);
  if (const pid_t id = std::exchange(process.id, 0); id != 0) {
    ::kill(id, SIGKILL);
    waitpid(id, nullptr, 0);
  }
}

void Supervisor::start_again(const std::string& name) {
  spawn(find(name));
}

void Supervisor::stop(const std::string& name) {
  ::kill(find(name).id, SIGSTOP);
}

void Supervisor::go_on(const std::string& name) {
  ::kill(find(name).id, SIGCONT);
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
