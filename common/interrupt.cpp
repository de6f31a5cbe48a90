#include "common/interrupt.hpp"

#include "common/error.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>

namespace evbal {
namespace {

constexpr unsigned grace_seconds = 10;
constexpr std::string_view late = "evbal: asked to end by a signal, did not end within 10 s\n";

// The kernel may choose any thread for the signal, one of Fast DDS's too, and another one asks.
std::atomic<int> interrupted_by = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal's handler must not wait for a lock");

void remember(int signal) {
  interrupted_by = signal;
  alarm(grace_seconds);
}

void end_now(int /*signal*/) {
  [[maybe_unused]] const ssize_t told = write(STDERR_FILENO, late.data(), late.size());
  _exit(static_cast<int>(ExitStatus::run_failed));
}

bool is_ignored(int signal) {
  struct sigaction now {};
  sigaction(signal, nullptr, &now);
  return now.sa_handler == SIG_IGN;
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = end_now;
  sigaction(SIGALRM, &action, nullptr);
  action.sa_handler = remember;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (!is_ignored(signal)) {
      sigaction(signal, &action, nullptr);
    }
  }
}

void check_interrupt() {
  if (const int signal = interrupted_by; signal != 0) {
    throw run_failed(signal == SIGINT ? "interrupted" : "asked to end by a signal");
  }
}

}  // namespace evbal
