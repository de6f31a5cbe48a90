#include "common/interrupt.hpp"

#include "common/error.hpp"

#include <csignal>

namespace evbal {
namespace {

volatile std::sig_atomic_t interrupted_by = 0;

void remember(int signal) {
  interrupted_by = signal;
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = remember;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    sigaction(signal, &action, nullptr);
  }
}

void check_interrupt() {
  if (interrupted_by != 0) {
    throw run_failed(interrupted_by == SIGINT ? "interrupted" : "asked to end by a signal");
  }
}

}  // namespace evbal
