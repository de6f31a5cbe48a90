#pragma once

#include "common/command.hpp"
#include "common/pipe.hpp"

#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

namespace evbal {

/// A process that reads lines from its standard input and answers in lines on its standard output. It ends with this
/// process, however this one ends, and no process that it has started, and so on, outlives it.
class ChildProcess {
 public:
  /// `command`: program, as find_program finds it, and arguments. Its stderr is the open file `errors`;
  /// no line is waited for longer than `patience`. This process ignores SIGPIPE from then on. Throws Error{run_failed}
  /// if the program cannot be started.
  explicit ChildProcess(Command command, int errors = STDERR_FILENO,
                        std::chrono::milliseconds patience = std::chrono::minutes(1));

  /// Ends it, as end() does.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Without the line's end. What is said to a child that has ended is lost, which read() tells. Throws
  /// Error{bad_input} if the child has said something that nobody asked for, and Error{run_failed} as read() does.
  void write(const std::string& line);

  /// The next line, without its end. Throws Error{run_failed} if it does not come in time or the child ends instead,
  /// naming how it ended and `what` was waited for, Error{bad_input} if the line is longer than 8 MB. Throws
  /// Error{run_failed} also once another thread ends the child, or the run is interrupted.
  std::string read(const std::string& what);

  /// The line that was read last, in words: "line 3 of `python3 mine.py`".
  std::string place() const { return place(lines_read_); }

  /// Closes the child's input and gives it 3 s to end by itself; then comes SIGTERM, and after another second SIGKILL.
  /// What it prints meanwhile, up to 1 MB, goes to its stderr. May be called while another thread reads or writes.
  void end();

 private:
  std::string place(int line) const;
  void refuse_if_ending() const;
  bool take_line(std::string& line);
  bool hear();
  bool has_ended() const;
  bool ends_within(std::chrono::milliseconds grace);
  void pass_on();
  int kill_now();

  Command command_;
  int errors_;
  std::chrono::milliseconds patience_;
  Pipe to_;
  Pipe from_;
  std::atomic<bool> ending_ = false;
  std::mutex mutex_;    ///< for all but ending_; held for a moment at a time
  std::string mark_;    ///< in the environment of the child and of all whom it starts
  pid_t id_ = 0;        ///< 0 once it has ended
  int ended_with_ = 0;  ///< status, once it has
  std::string heard_;   ///< and not yet read
  int lines_read_ = 0;  ///< from the start
  std::size_t may_pass_on_ = 1 << 20;
};

}  // namespace evbal
