#include "experiments/progress/progress.hpp"

#include "experiments/progress/live_view.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace evbal {
namespace {

/// One less than the terminal has: some break a line that is full.
int terminal_columns() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return std::max(20, (known ? size.ws_col : 80) - 1);
}

}  // namespace

Progress::Progress(std::string title, DayClock clock, std::vector<std::string> fault_names, bool quiet)
    : title_(std::move(title)),
      clock_(clock),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      watch_(clock, std::move(fault_names)) {}

void Progress::redraw(const std::vector<std::string>& lines) {
  std::string text = drawn_ > 0 ? "\033[" + std::to_string(drawn_) + "F" : "";
  for (const std::string& line : lines) {
    text += "\033[K" + line + "\n";
  }
  std::fputs(text.c_str(), stderr);
  drawn_ = lines.size();
}

void Progress::show(const TickRecord& record) {
  watch_.add(record);
  if (quiet_) {
    return;
  }
  DayState day = watch_.state();
  seen_.insert(day.faults.begin(), day.faults.end());
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double left = spent / day.ticks * (clock_.ticks() - day.ticks);
  if (terminal_) {
    redraw(live_view(title_, clock_, day, left, terminal_columns()));
  } else if ((clock_.start + clock_.minute_of(day.ticks)) % 60 == 0) {
    day.faults.assign(seen_.begin(), seen_.end());
    seen_.clear();
    std::fprintf(stderr, "%s\n", live_line(title_, clock_, day, left).c_str());
  }
}

}  // namespace evbal
