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

// Seconds of one run; of short ones the mean over a batch, as processor clocks are coarse. Negative if the work fails.
double batch(const Work& work) {
  constexpr double long_enough = 0.2;
  const double start = seconds_so_far();
  double spent = 0.0;
  int times = 0;
  while (spent < long_enough) {
    if (!work()) {
      return -1.0;
    }
    ++times;
    spent = seconds_so_far() - start;
  }
  return spent / times;
}

std::optional<Cost> done(const std::function<Work()>& prepare) {
  constexpr int batches = 5;
  constexpr double enough = 2.0;
  const Work work = prepare();
  double least = batch(work);
  for (int i = 1; i < batches && least >= 0.0 && least < enough; ++i) {
    least = std::min(least, batch(work));
  }
  if (least < 0.0) {
    return std::nullopt;
  }
  return Cost{least, std::max(megabytes_of(RUSAGE_SELF), megabytes_of(RUSAGE_CHILDREN))};
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
  rusage usage{};  // of the child and of those that it waited for
  wait4(child, nullptr, 0, &usage);
  if (received) {
    return cost;
  }
  const bool stopped = usage.ru_utime.tv_sec + usage.ru_stime.tv_sec + 1 >= limit;
  return stopped ? std::optional(Cost{static_cast<double>(limit), 0.0, false}) : std::nullopt;
}

}  // namespace evbal
