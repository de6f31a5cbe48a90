#include "common/workers.hpp"

#include "common/error.hpp"
#include "common/interrupt.hpp"

#include <fcntl.h>
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

namespace evbal {
namespace {

using namespace std::chrono_literals;

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
std::string complaint_of(int pipe, int status) {
  std::array<char, 4096> text{};
  const ssize_t length = read(pipe, text.data(), text.size());
  if (WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS) {
    return "";
  }
  if (WIFSIGNALED(status)) {
    return std::string("its process was ended by signal ") + strsignal(WTERMSIG(status));
  }
  return length > 0 ? std::string(text.data(), static_cast<std::size_t>(length)) : "its process failed";
}

}  // namespace

Workers::~Workers() {
  for (const auto& worker : workers_) {
    kill(worker.id, SIGKILL);
    waitpid(worker.id, nullptr, 0);
    close(worker.complaint);
  }
}

void Workers::start(std::size_t job, const std::function<void(std::size_t)>& work) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw run_failed(std::string("no pipe to a process: ") + std::strerror(errno));
  }
  const pid_t self = getpid();
  const pid_t id = fork();
  if (id == 0) {
    work_as_child(self, ends[1], [&] { work(job); });
  }
  close(ends[1]);
  if (id < 0) {
    close(ends[0]);
    throw run_failed(std::string("no process can be started: ") + std::strerror(errno));
  }
  workers_.push_back({job, id, ends[0]});
}

void Workers::reap(const std::function<void(std::size_t, const std::string&)>& done) {
  for (;; std::this_thread::sleep_for(10ms)) {
    check_interrupt();
    for (auto worker = workers_.begin(); worker != workers_.end(); ++worker) {
      int status = 0;
      if (waitpid(worker->id, &status, WNOHANG) == worker->id) {
        const Worker ended = *worker;
        workers_.erase(worker);
        const std::string complaint = complaint_of(ended.complaint, status);
        close(ended.complaint);
        done(ended.job, complaint);
        return;
      }
    }
  }
}

void work_through(const std::vector<std::size_t>& jobs, int at_a_time, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t, const std::string&)>& done) {
  Workers workers;
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
