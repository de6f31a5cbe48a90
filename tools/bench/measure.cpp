#include "tools/bench/measure.hpp"

#include "common/error.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>

namespace evbal {
namespace {

double megabytes_of(int who) {
  rusage usage{};
  getrusage(who, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// Of this process and of those that it waited for.
double seconds_so_far() {
  timespec own{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &own);
  rusage children{};
  getrusage(RUSAGE_CHILDREN, &children);
  return static_cast<double>(own.tv_sec) + 1e-9 * static_cast<double>(own.tv_nsec) +
         static_cast<double>(children.ru_utime.tv_sec) + 1e-6 * static_cast<double>(children.ru_utime.tv_usec);
}

std::optional<Cost> done(const std::function<Work()>& prepare) {
  constexpr double enough = 0.5;
  const Work work = prepare();
  const double start = seconds_so_far();
  double spent = 0.0;
  int times = 0;
  while (spent < enough) {
    if (!work()) {
      return std::nullopt;
    }
    ++times;
    spent = seconds_so_far() - start;
  }
  return Cost{spent / times, std::max(megabytes_of(RUSAGE_SELF), megabytes_of(RUSAGE_CHILDREN))};
}

}  // namespace

std::optional<Cost> measure(const std::function<Work()>& prepare, int limit) {
  std::array<int, 2> pipes{};
  if (pipe(pipes.data()) != 0) {
    throw run_failed("no pipe can be made");
  }
  const pid_t child = fork();
  if (child == 0) {
    const rlimit seconds{.rlim_cur = static_cast<rlim_t>(limit), .rlim_max = static_cast<rlim_t>(limit)};
    setrlimit(RLIMIT_CPU, &seconds);
    const auto cost = done(prepare);
    const bool sent = cost && write(pipes[1], &*cost, sizeof *cost) == static_cast<ssize_t>(sizeof *cost);
    _exit(sent ? 0 : 1);
  }
  close(pipes[1]);
  Cost cost;
  const bool received = read(pipes[0], &cost, sizeof cost) == static_cast<ssize_t>(sizeof cost);
  close(pipes[0]);
  waitpid(child, nullptr, 0);
  return received ? std::optional(cost) : std::nullopt;
}

}  // namespace evbal
