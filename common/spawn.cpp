#include "common/spawn.hpp"

#include "common/error.hpp"
#include "common/pipe.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace evbal {
namespace {

/// Makes `streams` the standard streams, whatever their numbers, and closes every other file but `failure`, which
/// closes when the program starts.
void arrange_files(const StandardStreams& streams, int failure) {
  constexpr int above = STDERR_FILENO + 1;
  const std::array<int, 3> standard = {fcntl(streams.input, F_DUPFD, above), fcntl(streams.output, F_DUPFD, above),
                                       fcntl(streams.errors, F_DUPFD, above)};
  const int kept = fcntl(failure, F_DUPFD_CLOEXEC, above);
  for (int i = 0; i < above; ++i) {
    dup2(standard[i], i);
  }
  if (kept != above) {
    dup3(kept, above, O_CLOEXEC);
  }
  closefrom(above + 1);
}

/// What this process catches must not reach its handlers in the new one, which still shares its memory; what it ignores
/// stays ignored.
void catch_nothing() {
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) {
      action.sa_handler = SIG_DFL;
      sigaction(number, &action, nullptr);
    }
  }
  std::signal(SIGPIPE, SIG_DFL);
}

/// In the new process, which has the memory of this one until the program starts: nothing but system calls.
[[noreturn]] void become(char* const* words, char* const* environment, const StandardStreams& streams, int failure,
                         pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) {
    _exit(EXIT_FAILURE);
  }
  setpgid(0, 0);
  catch_nothing();
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  arrange_files(streams, failure);
  execvpe(words[0], words, environment);
  const int error = errno;
  [[maybe_unused]] const ssize_t told = write(STDERR_FILENO + 1, &error, sizeof error);
  _exit(EXIT_FAILURE);
}

/// As exec has it.
char* word(const std::string& text) {
  return const_cast<char*>(text.c_str());  // NOLINT(cppcoreguidelines-pro-type-const-cast)
}

/// Whether the process of that folder in /proc was started with `mark`; not, if it is not this user's or has ended.
bool is_marked(const std::filesystem::path& process, const std::string& mark) {
  std::ifstream environment(process / "environ", std::ios::binary);
  std::string assignment;
  while (std::getline(environment, assignment, '\0')) {
    if (assignment == mark) {
      return true;
    }
  }
  return false;
}

/// Kills who is marked now, and says whether there was anybody.
bool kill_marked_once(const std::string& mark) {
  bool found = false;
  std::error_code ended_meanwhile;
  for (const auto& process : std::filesystem::directory_iterator("/proc", ended_meanwhile)) {
    const std::string name = process.path().filename();
    if (std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; }) && is_marked(process.path(), mark)) {
      found = kill(static_cast<pid_t>(std::stol(name)), SIGKILL) == 0 || found;
    }
  }
  return found;
}

}  // namespace

void kill_marked(const std::string& mark) {
  constexpr int rounds = 100;  // a process may start another while this one looks
  for (int i = 0; i < rounds && kill_marked_once(mark); ++i) {
  }
}

pid_t spawn(const Command& command, const StandardStreams& streams, const std::string& mark) {
  std::vector<char*> words;
  words.reserve(command.size() + 1);
  std::ranges::transform(command, std::back_inserter(words), word);
  words.push_back(nullptr);
  std::vector<char*> environment;
  for (char** assignment = environ; *assignment != nullptr; ++assignment) {
    environment.push_back(*assignment);
  }
  if (!mark.empty()) {
    environment.push_back(word(mark));
  }
  environment.push_back(nullptr);
  Pipe failure;
  const pid_t parent = getpid();
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t id = vfork();  // to copy the tables of a launcher's memory takes longer than the rest of it
  if (id == 0) {
    become(words.data(), environment.data(), streams, failure.write_end(), parent);
  }
  int error = id < 0 ? errno : 0;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  failure.close_write_end();
  if (id > 0 && read(failure.read_end(), &error, sizeof error) > 0) {
    waitpid(id, nullptr, 0);
  }
  if (error != 0) {
    throw run_failed("`" + shown(command) + "` cannot be started: " + std::strerror(error));
  }
  return id;
}

bool ended_from_outside(int status) {
  static constexpr std::array from_outside = {SIGKILL, SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2};
  return WIFSIGNALED(status) && std::ranges::find(from_outside, WTERMSIG(status)) != from_outside.end();
}

std::string ending(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return "was ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  }
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace evbal
