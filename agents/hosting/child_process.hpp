#pragma once

#include "common/command.hpp"
#include "common/pipe.hpp"

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

namespace evbal {

/// A process that reads lines from its standard input and answers in lines on its standard output; what it prints on
/// stderr goes where ours does. Ends with this process, however this one ends.
class ChildProcess {
 public:
  /// `command`: program, looked for in $PATH if it has no slash, and arguments. This process ignores SIGPIPE from then
  /// on. Throws Error{run_failed} if the program cannot be started.
  explicit ChildProcess(Command command);

  /// Ends it, as end() does.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Without the line's end. What is said to a child that has ended is lost, which read() tells. Throws
  /// Error{run_failed} once another thread ends the child, as read() does.
  void write(const std::string& line);

  /// The next line, without its end. Throws Error{run_failed} if the child ends instead, naming it, how it ended and
  /// `what` was waited for.
  std::string read(const std::string& what);

  /// Lines that the child has answered so far.
  int lines_read() const { return lines_read_; }

  /// Closes the child's input and gives it 3 s to end by itself; then comes SIGTERM, and after another second SIGKILL.
  /// What it prints meanwhile goes to our stderr. May be called while another thread reads or writes.
  void end();

 private:
  void refuse_if_ending() const;
  bool hear();
  bool ends_within(std::chrono::milliseconds grace);
  int kill_now();

  Command command_;
  Pipe to_;
  Pipe from_;
  std::atomic<bool> ending_ = false;
  std::mutex mutex_;   ///< for all but ending_; held for a moment at a time
  pid_t id_ = 0;       ///< 0 once it has ended
  std::string heard_;  ///< and not yet read
  int lines_read_ = 0;
};

}  // namespace evbal
