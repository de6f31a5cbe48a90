#include "agents/protocol/origin.hpp"

#include <unistd.h>

#include <ctime>

namespace evbal {

double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Origin origin_since(double started) {
  return {.process_id = getpid(), .seconds = thread_cpu_seconds() - started};
}

}  // namespace evbal
