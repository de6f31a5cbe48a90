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

/// In the new process, where other threads may have held any lock: nothing but system calls.
[[noreturn]] void become(char* const* words, const StandardStreams& streams, int failure, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) {
    _exit(EXIT_FAILURE);
  }
  setpgid(0, 0);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  std::signal(SIGPIPE, SIG_DFL);
  arrange_files(streams, failure);
  execvp(words[0], words);
  const int error = errno;
  [[maybe_unused]] const ssize_t told = write(STDERR_FILENO + 1, &error, sizeof error);
  _exit(EXIT_FAILURE);
}

}  // namespace

pid_t spawn(const Command& command, const StandardStreams& streams) {
  std::vector<char*> words;
  words.reserve(command.size() + 1);
  for (const auto& word : command) {
    words.push_back(const_cast<char*>(word.c_str()));  // NOLINT(cppcoreguidelines-pro-type-const-cast): as exec has it
  }
  words.push_back(nullptr);
  Pipe failure;
  const pid_t parent = getpid();
  const pid_t id = fork();
  if (id == 0) {
    become(words.data(), streams, failure.write_end(), parent);
  }
  int error = id < 0 ? errno : 0;
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
