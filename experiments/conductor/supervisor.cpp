#include "experiments/conductor/supervisor.hpp"

#include "common/contract.hpp"
#include "common/error.hpp"
#include "experiments/conductor/lossy_network.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <fstream>
#include <thread>
#include <utility>

namespace evbal {
namespace {

using namespace std::chrono_literals;

constexpr int most_deaths = 5;  // of one process without progress of the run

std::string ending(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return "was ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  }
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

/// The process of that name, which exists.
auto& named(auto& processes, const std::string& name) {
  const auto found = std::find_if(processes.begin(), processes.end(), [&](const auto& p) { return p.name == name; });
  EVBAL_EXPECT(found != processes.end(), "the name of a process");
  return *found;
}

/// How posix_spawn sets a process up: its own process group (Ctrl-C is the launcher's), the pipe as standard input,
/// output to the log, nothing else open, default signals.
class SpawnSetup {
 public:
  SpawnSetup(int pipe, const std::filesystem::path& log) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_adddup2(&files_, pipe, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
    posix_spawn_file_actions_adddup2(&files_, STDOUT_FILENO, STDERR_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  }
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;

  const posix_spawn_file_actions_t* files() const { return &files_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

Supervisor::Supervisor(std::filesystem::path log_folder) : log_folder_(std::move(log_folder)) {
  std::filesystem::create_directories(log_folder_);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw run_failed(std::string("no pipe to the run's processes: ") + std::strerror(errno));
  }
  pipe_read_ = ends[0];
  pipe_write_ = ends[1];
}

Supervisor::~Supervisor() {
  close(pipe_write_);
  end(2s);
  close(pipe_read_);
}

void Supervisor::start(const std::string& name, const std::filesystem::path& program,
                       const std::vector<std::string>& arguments, int network) {
  Process process{.name = name, .words = {program.string()}, .network = network};
  process.words.insert(process.words.end(), arguments.begin(), arguments.end());
  spawn(process);
  processes_.push_back(std::move(process));
}

void Supervisor::spawn(Process& process) {
  std::vector<char*> pointers;
  pointers.reserve(process.words.size() + 1);
  for (auto& word : process.words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const SpawnSetup setup(pipe_read_, log_folder_ / (process.name + ".log"));
  const InNamespace network(process.network);
  const int error =
      posix_spawn(&process.id, pointers.front(), setup.files(), setup.attributes(), pointers.data(), environ);
  if (error != 0) {
    process.id = 0;
    throw run_failed("cannot start " + process.words.front() + ": " + std::strerror(error));
  }
}

std::vector<Death> Supervisor::revive() {
  std::vector<Death> deaths;
  for (auto& process : processes_) {
    int status = 0;
    if (process.id == 0 || waitpid(process.id, &status, WNOHANG) != process.id) {
      continue;
    }
    const std::string how = "process " + std::to_string(std::exchange(process.id, 0)) + " " + ending(status);
    if (!WIFSIGNALED(status)) {
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

void Supervisor::end(std::chrono::milliseconds grace) {
  const auto deadline = std::chrono::steady_clock::now() + grace;
  for (auto& process : processes_) {
    if (process.id != 0) {
      ::kill(process.id, SIGCONT);  // who stands still cannot see the pipe close
    }
    while (process.id != 0 && waitpid(process.id, nullptr, WNOHANG) == 0) {
      if (std::chrono::steady_clock::now() > deadline) {
        ::kill(process.id, SIGKILL);
        waitpid(process.id, nullptr, 0);
        break;
      }
      std::this_thread::sleep_for(1ms);
    }
    process.id = 0;
  }
}

std::string Supervisor::last_words(const std::string& name) const {
  std::ifstream log(log_folder_ / (name + ".log"));
  std::string last;
  for (std::string line; std::getline(log, line);) {
    last = line.empty() ? last : line;
  }
  return last.empty() ? "" : ": " + last;
}

}  // namespace evbal
