#include "common/workers.hpp"

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "common/spawn.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <utility>

namespace evbal {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

[[noreturn]] void work_as_child(pid_t parent, int complaint, const std::function<void()>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) {
    _exit(EXIT_FAILURE);
  }
  try {
    work();
    _exit(EXIT_SUCCESS);
  } catch (const std::exception& error) {
    const ssize_t told = write(complaint, error.what(), std::strlen(error.what()));
    _exit(told < 0 ? EXIT_FAILURE + 1 : EXIT_FAILURE);
  }
}

/// What a worker, which has ended, complained of.
std::string complaint_of(const Pipe& pipe, int status) {
  std::array<char, 4096> text{};
  const ssize_t length = read(pipe.read_end(), text.data(), text.size());
  if (WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS) {
    return "";
  }
  if (WIFSIGNALED(status)) {
    return "its process " + ending(status);
  }
  return length > 0 ? std::string(text.data(), static_cast<std::size_t>(length)) : "its process failed";
}

std::string too_late(std::chrono::milliseconds longest) {
  return "took longer than " + decimal(std::chrono::duration<double>(longest).count()) + " s, and was ended";
}

}  // namespace

Workers::~Workers() {
  for (const auto& worker : workers_) {
    kill(worker.id, SIGKILL);
  }
  for (const auto& worker : workers_) {
    waitpid(worker.id, nullptr, 0);
  }
}

void Workers::start(std::size_t job, const std::function<void(std::size_t)>& work) {
  auto complaint = std::make_unique<Pipe>();
  const pid_t self = getpid();
  const pid_t id = fork();
  if (id == 0) {
    work_as_child(self, complaint->write_end(), [&] { work(job); });
  }
  if (id < 0) {
    throw run_failed(std::string("no process can be started: ") + std::strerror(errno));
  }
  complaint->close_write_end();
  workers_.push_back({.job = job, .id = id, .complaint = std::move(complaint), .start = Clock::now()});
}

void Workers::reap(const std::function<void(std::size_t, const std::string&)>& done) {
  for (;; std::this_thread::sleep_for(10ms)) {
    check_interrupt();
    for (auto worker = workers_.begin(); worker != workers_.end(); ++worker) {
      int status = 0;
      if (waitpid(worker->id, &status, WNOHANG) == worker->id) {
        const Worker ended = std::move(*worker);
        workers_.erase(worker);
        done(ended.job, ended.late ? too_late(longest_) : complaint_of(*ended.complaint, status));
        return;
      }
      if (longest_ > 0ms && !worker->late && Clock::now() - worker->start > longest_) {
        kill(worker->id, SIGKILL);
        worker->late = true;
      }
    }
  }
}

void work_through(const std::vector<std::size_t>& jobs, int at_a_time, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t, const std::string&)>& done, std::chrono::milliseconds longest) {
  Workers workers(longest);
  for (const std::size_t job : jobs) {
    if (workers.count() == static_cast<std::size_t>(at_a_time)) {
      workers.reap(done);
    }
    workers.start(job, work);
  }
  while (workers.count() > 0) {
    workers.reap(done);
  }
}

}  // namespace evbal
