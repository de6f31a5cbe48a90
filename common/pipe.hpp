#pragma once

namespace evbal {

/// A pipe of this process, which no program that it starts inherits unasked.
class Pipe {
 public:
  /// Throws Error{run_failed} if the system has none left.
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  /// -1 once closed.
  int read_end() const { return read_end_; }
  /// Its file descriptor, -1 if closed.
  int write_end() const { return write_end_; }

  /// Closes it, if it is open.
  void close_read_end();
  /// Closes it, if it is open.
  void close_write_end();

 private:
  int read_end_ = -1;
  int write_end_ = -1;
};

}  // namespace evbal
