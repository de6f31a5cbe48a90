#pragma once

#include <stdexcept>
#include <string>

namespace evbal {

/// Exit status of every program of this project.
enum class ExitStatus {
  ok = 0,
  expectation_failed = 1,  ///< an `expect` of the scenario does not hold
  bad_input = 2,           ///< the user's input is wrong; the message says where and what would be right
  run_failed = 3,          ///< the run could not be carried through
};

/// A user's error, or an end that a user must be told of. `main` prints what() and exits with status().
/// Programmer's errors never throw: they abort (common/contract.hpp).
class Error : public std::runtime_error {
 public:
  /// `status` is the exit status of a program that this error ends.
  Error(ExitStatus status, const std::string& message) : std::runtime_error(message), status_(status) {}

  /// Exit status of a program that this error ends.
  ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

/// Wrong input without a place in a file (a command-line argument).
Error bad_input(const std::string& message);

/// Wrong input at `file:line`; lines count from 1, 0 leaves the line out.
Error bad_input(const std::string& file, int line, const std::string& message);

/// The run could not be carried through.
Error run_failed(const std::string& message);

}  // namespace evbal
