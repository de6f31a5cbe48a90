#pragma once

#include "common/pipe.hpp"

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace evbal {

/// Processes at work for this one, each on a job of its own. If this process dies they do, and so do those that are
/// left when the object does. No other thread may run when one is started.
class Workers {
 public:
  /// A worker that is at it for longer than `longest` is ended; 0: none is.
  explicit Workers(std::chrono::milliseconds longest = std::chrono::milliseconds::zero()) : longest_(longest) {}
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Workers that are at work.
  std::size_t count() const { return workers_.size(); }

  /// Does `work` of the job in a new process. Throws Error{run_failed} if none can be started.
  void start(std::size_t job, const std::function<void(std::size_t)>& work);

  /// Waits until one ends, of which there must be one; `done` hears what went wrong with its job, or an empty text.
  /// Throws Error{run_failed} if interrupted.
  void reap(const std::function<void(std::size_t, const std::string&)>& done);

 private:
  struct Worker {
    std::size_t job = 0;
    pid_t id = 0;
    std::unique_ptr<Pipe> complaint{};  ///< in which it says what went wrong
    std::chrono::steady_clock::time_point start{};
    bool late = false;  ///< was told to end
  };

  std::chrono::milliseconds longest_;
  std::vector<Worker> workers_;
};

/// Does each of `jobs`, `at_a_time` of them at a time, each in a process of its own: solvers are made for one solve at
/// a time in a process, and one that crashes takes nobody along. `done` hears of each that ends, here, with what went
/// wrong or an empty text; if it or an interrupt ends the work early, those at work are ended, and so is a job that
/// takes longer than `longest`, unless that is 0. Throws as Workers do. No other thread may run meanwhile.
void work_through(const std::vector<std::size_t>& jobs, int at_a_time, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t, const std::string&)>& done,
                  std::chrono::milliseconds longest = std::chrono::milliseconds::zero());

}  // namespace evbal
