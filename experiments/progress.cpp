#include "experiments/progress.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace evbal {

std::string shown_seconds(double seconds) {
  const long whole = std::lround(seconds);
  return whole < 60 ? std::to_string(whole) + " s"
                    : std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

Progress::Progress(std::string title, DayClock clock, std::vector<std::string> fault_names, bool quiet)
    : title_(std::move(title)),
      clock_(clock),
      fault_names_(std::move(fault_names)),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (line_open_) {
    std::fputs("\n", stderr);
  }
}

std::string Progress::line(const TickRecord& record) const {
  const int ticks_done = record.tick.tick + 1;
  const int minute = clock_.minute_of(ticks_done);
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  std::string text = title_ + "  step " + std::to_string(clock_.step_of(clock_.minute_of(record.tick.tick)) + 1) + "/" +
                     std::to_string(clock_.steps()) + "  " + time_of_day(clock_, minute) + "  served " +
                     std::to_string(served_) + "  lost " + std::to_string(lost_);
  for (const int fault : active_) {
    text += "  [" + fault_names_.at(static_cast<std::size_t>(fault)) + "]";
  }
  return text + "  " + shown_seconds(spent / ticks_done * (clock_.ticks() - ticks_done)) + " left";
}

void Progress::show(const TickRecord& record) {
  for (const auto& said : record.exchange.departures) {
    for (const auto& fate : said.fates) {
      ++(fate.served ? served_ : lost_);
    }
  }
  for (const auto& effect : record.faults.effects) {
    active_.insert(effect.fault);
  }
  if (quiet_) {
    return;
  }
  if (terminal_) {
    std::fprintf(stderr, "\r\033[K%s", line(record).c_str());
    line_open_ = true;
    active_.clear();
  } else if ((clock_.start + clock_.minute_of(record.tick.tick + 1)) % 60 == 0) {
    std::fprintf(stderr, "%s\n", line(record).c_str());
    active_.clear();
  }
}

}  // namespace evbal
