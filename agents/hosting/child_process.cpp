#include "agents/hosting/child_process.hpp"

#include "common/error.hpp"
#include "common/installation.hpp"
#include "common/interrupt.hpp"
#include "common/spawn.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <string_view>
#include <utility>

namespace evbal {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// Together less than a run's processes are given to end (process.hpp).
constexpr auto grace_after_input = 3s;
constexpr auto grace_after_term = 1s;

constexpr std::size_t longest_line = 8'000'000;

/// The command with its program's path, if there is such a program.
Command as_found(Command command) {
  const auto program = find_program(command.front());
  command.front() = program.empty() ? command.front() : program.string();
  return command;
}

/// Whether the file can be read or written without waiting, if need be after a moment.
bool ready(int file, short events, std::chrono::milliseconds moment) {
  pollfd asked{file, events, 0};
  return poll(&asked, 1, static_cast<int>(moment.count())) > 0;
}

std::string in_words(std::chrono::milliseconds time) {
  return std::to_string(std::chrono::duration_cast<std::chrono::seconds>(time).count()) + " s";
}

/// An assignment for the environment of one child, that no other's has.
std::string new_mark() {
  static std::atomic<int> children = 0;
  return "EVBAL_CHILD=" + std::to_string(getpid()) + "-" + std::to_string(++children);
}

/// The beginning of what was said, fit for a message.
std::string beginning(const std::string& text) {
  std::string shown = text.substr(0, std::min<std::size_t>(text.find('\n'), 40));
  std::ranges::replace_if(
      shown, [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
  return shown;
}

}  // namespace

ChildProcess::ChildProcess(Command command, int errors, std::chrono::milliseconds patience)
    : command_(std::move(command)), errors_(errors), patience_(patience), mark_(new_mark()) {
  std::signal(SIGPIPE, SIG_IGN);
  id_ = spawn(as_found(command_), {.input = to_.read_end(), .output = from_.write_end(), .errors = errors_}, mark_);
  to_.close_read_end();
  from_.close_write_end();
  fcntl(to_.write_end(), F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
  end();
}

std::string ChildProcess::place(int line) const {
  return "line " + std::to_string(line) + " of `" + shown(command_) + "`";
}

void ChildProcess::refuse_if_ending() const {
  if (ending_) {
    throw run_failed("`" + shown(command_) + "` is told to end");
  }
  check_interrupt();
}

void ChildProcess::write(const std::string& line) {
  const std::string text = line + "\n";
  std::string_view rest = text;
  const auto deadline = Clock::now() + patience_;
  for (bool first = true; !rest.empty(); first = false) {
    const std::lock_guard lock(mutex_);
    refuse_if_ending();
    if (first && ready(from_.read_end(), POLLIN, 0ms)) {
      hear();
    }
    if (first && !heard_.empty()) {
      kill_now();
      throw bad_input(place(lines_read_ + 1) + ": `" + beginning(heard_) +
                      "` was said before it was asked for; give one line for each question");
    }
    if (ready(to_.write_end(), POLLOUT, 100ms)) {
      const ssize_t written = ::write(to_.write_end(), rest.data(), rest.size());
      if (written < 0) {
        return;
      }
      rest.remove_prefix(static_cast<std::size_t>(written));
    } else if (Clock::now() >= deadline) {
      kill_now();
      throw run_failed(place(lines_read_ + 1) + ": the question for it is not read within " + in_words(patience_));
    }
  }
}

std::string ChildProcess::read(const std::string& what) {
  const auto deadline = Clock::now() + patience_;
  for (;;) {
    const std::lock_guard lock(mutex_);
    refuse_if_ending();
    std::string line;
    if (take_line(line)) {
      return line;
    }
    const std::string next = place(lines_read_ + 1);
    if (heard_.size() > longest_line) {
      kill_now();
      throw bad_input(next + ": is longer than 8 MB, instead of " + what);
    }
    // Asked for before its output is: a process that the child has left behind may hold that open.
    const bool ended = has_ended();
    const bool came = ready(from_.read_end(), POLLIN, 100ms);
    if (came ? !hear() : ended) {
      const std::string half = heard_.empty() ? "" : " after half a line, `" + beginning(heard_) + "`,";
      throw run_failed(next + ": it " + ending(kill_now()) + half + " and owes " + what);
    }
    if (!came && Clock::now() >= deadline) {
      const std::string half = heard_.empty() ? "" : " but half a line, `" + beginning(heard_) + "`";
      kill_now();
      throw run_failed(next + ": nothing came within " + in_words(patience_) + half + "; it owes " + what);
    }
  }
}

/// Takes the next line, if all of it was heard.
bool ChildProcess::take_line(std::string& line) {
  const auto end = heard_.find('\n');
  if (end == std::string::npos) {
    return false;
  }
  ++lines_read_;
  line = heard_.substr(0, end);
  heard_.erase(0, end + 1);
  return true;
}

/// Takes what the child has said, waiting for it; false if it has closed its output.
bool ChildProcess::hear() {
  std::array<char, 1 << 16> part{};
  const ssize_t length = ::read(from_.read_end(), part.data(), part.size());
  heard_.append(part.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
  return length > 0;
}

/// Whether the child has ended; its id stays its own until kill_now().
bool ChildProcess::has_ended() const {
  siginfo_t info{};
  return id_ == 0 ||
         (waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid != 0);
}

void ChildProcess::end() {
  ending_ = true;
  const std::lock_guard lock(mutex_);
  to_.close_write_end();
  if (id_ != 0 && !ends_within(grace_after_input)) {
    kill(-id_, SIGTERM);
    ends_within(grace_after_term);
  }
  kill_now();
}

/// Whether the child ends in time; passes on what it says meanwhile.
bool ChildProcess::ends_within(std::chrono::milliseconds grace) {
  const auto deadline = Clock::now() + grace;
  bool ended = false;
  do {
    ended = has_ended();
    if (ready(from_.read_end(), POLLIN, ended ? 0ms : 10ms) && !hear()) {
      from_.close_read_end();
    }
    pass_on();
  } while (!ended && Clock::now() < deadline);
  return ended;
}

/// Writes what the child has said, and nobody asked for, to its stderr.
void ChildProcess::pass_on() {
  const std::size_t length = std::min(heard_.size(), may_pass_on_);
  [[maybe_unused]] const ssize_t passed_on = ::write(errors_, heard_.data(), length);
  may_pass_on_ -= length;
  heard_.clear();
}

/// Kills the child and all whom it has started, and gives the status with which it has ended.
int ChildProcess::kill_now() {
  if (id_ != 0) {
    kill(-id_, SIGKILL);  // also one that has only closed its output
    waitpid(std::exchange(id_, 0), &ended_with_, 0);
    kill_marked(mark_);  // also those who have left the group
  }
  return ended_with_;
}

}  // namespace evbal
