#pragma once

#include <sys/types.h>

#include <cstdio>
#include <string>
#include <vector>

namespace evbal {

/// A process that reads lines from its standard input and answers in lines on its standard output; what it prints on
/// stderr goes where ours does. Ends with this process, however this one ends.
class ChildProcess {
 public:
  /// `command`: program, looked for in $PATH if it has no slash, and arguments. Throws Error{run_failed} if there are
  /// no means to start it; a program that is missing shows when it is spoken to.
  explicit ChildProcess(std::vector<std::string> command);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Without the line's end. What is said to a child that has ended is lost, which read() tells.
  void write(const std::string& line);

  /// The next line, without its end. Throws Error{run_failed} if the child ends instead, naming it, how it ended and
  /// `what` was waited for.
  std::string read(const std::string& what);

  int lines_read() const { return lines_read_; }

 private:
  std::vector<std::string> command_;
  pid_t id_ = 0;
  std::FILE* to_ = nullptr;
  std::FILE* from_ = nullptr;
  int lines_read_ = 0;
};

}  // namespace evbal
