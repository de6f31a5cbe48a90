#include "agents/hosting/child_process.hpp"

#include "common/error.hpp"
#include "common/spawn.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <string_view>
#include <utility>

namespace evbal {
namespace {

using namespace std::chrono_literals;

// Together less than a run's processes are given to end (process.hpp).
constexpr auto grace_after_input = 3s;
constexpr auto grace_after_term = 1s;

/// Whether the file can be read or written without waiting, if need be after a moment.
bool ready(int file, short events, std::chrono::milliseconds moment) {
  pollfd asked{file, events, 0};
  return poll(&asked, 1, static_cast<int>(moment.count())) > 0;
}

}  // namespace

ChildProcess::ChildProcess(Command command) : command_(std::move(command)) {
  std::signal(SIGPIPE, SIG_IGN);
  id_ = spawn(command_, {.input = to_.read_end(), .output = from_.write_end(), .errors = STDERR_FILENO});
  to_.close_read_end();
  from_.close_write_end();
  fcntl(to_.write_end(), F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
  end();
}

void ChildProcess::refuse_if_ending() const {
  if (ending_) {
    throw run_failed("`" + shown(command_) + "` is told to end");
  }
}

void ChildProcess::write(const std::string& line) {
  const std::string text = line + "\n";
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::lock_guard lock(mutex_);
    refuse_if_ending();
    if (ready(to_.write_end(), POLLOUT, 100ms)) {
      const ssize_t written = ::write(to_.write_end(), rest.data(), rest.size());
      if (written < 0) {
        return;
      }
      rest.remove_prefix(static_cast<std::size_t>(written));
    }
  }
}

std::string ChildProcess::read(const std::string& what) {
  for (;;) {
    const std::lock_guard lock(mutex_);
    refuse_if_ending();
    const auto end = heard_.find('\n');
    const bool closed = end == std::string::npos && ready(from_.read_end(), POLLIN, 100ms) && !hear();
    if (end != std::string::npos || (closed && !heard_.empty())) {
      ++lines_read_;
      std::string line = heard_.substr(0, end);
      heard_.erase(0, line.size() + 1);
      return line;
    }
    if (closed) {
      throw run_failed("`" + shown(command_) + "` " + ending(kill_now()) + " and owes " + what);
    }
  }
}

/// Takes what the child has said, waiting for it; false if it has closed its output.
bool ChildProcess::hear() {
  std::array<char, 1 << 16> part{};
  const ssize_t length = ::read(from_.read_end(), part.data(), part.size());
  heard_.append(part.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
  return length > 0;
}

void ChildProcess::end() {
  ending_ = true;
  const std::lock_guard lock(mutex_);
  to_.close_write_end();
  if (id_ != 0 && !ends_within(grace_after_input)) {
    kill(-id_, SIGTERM);
    if (!ends_within(grace_after_term)) {
      kill_now();
    }
  }
}

/// Whether the child ends in time; passes on what it says meanwhile.
bool ChildProcess::ends_within(std::chrono::milliseconds grace) {
  const auto deadline = std::chrono::steady_clock::now() + grace;
  do {
    const bool ended = waitpid(id_, nullptr, WNOHANG) == id_;
    if (ready(from_.read_end(), POLLIN, ended ? 0ms : 10ms) && !hear()) {
      from_.close_read_end();
    }
    [[maybe_unused]] const ssize_t passed_on = ::write(STDERR_FILENO, heard_.data(), heard_.size());
    heard_.clear();
    if (ended) {
      id_ = 0;
    }
  } while (id_ != 0 && std::chrono::steady_clock::now() < deadline);
  return id_ == 0;
}

/// Kills the child and gives the status with which it has ended.
int ChildProcess::kill_now() {
  int status = 0;
  kill(-id_, SIGKILL);  // also one that has only closed its output
  waitpid(std::exchange(id_, 0), &status, 0);
  return status;
}

}  // namespace evbal
