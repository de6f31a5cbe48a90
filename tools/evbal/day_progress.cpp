#include "tools/evbal/day_progress.hpp"

#include "experiments/progress/live_view.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace evbal {
namespace {

/// One less than the terminal has: some break a line that is full.
int terminal_columns() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return std::max(20, (known ? size.ws_col : 80) - 1);
}

std::vector<std::string> fault_names(const Schedule& schedule) {
  std::vector<std::string> names;
  for (const auto& fault : schedule.faults) {
    names.push_back(fault.name);
  }
  return names;
}

}  // namespace

DayProgress::DayProgress(const Scenario& scenario)
    : title_(scenario.planning.controller),
      clock_(scenario.world.clock),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      watch_(clock_, fault_names(scenario.schedule)) {}

void DayProgress::redraw(const std::vector<std::string>& lines) {
  std::string text = drawn_ > 0 ? "\033[" + std::to_string(drawn_) + "F" : "";
  for (const std::string& line : lines) {
    text += "\033[K" + line + "\n";
  }
  std::fputs(text.c_str(), stderr);
  drawn_ = lines.size();
}

void DayProgress::show(const TickRecord& record) {
  watch_.add(record);
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

void DayProgress::note_pace(const DayPace& pace) {
  if (pace.paused != paused_) {
    paused_ = pace.paused;
    std::fprintf(stderr, "%s %s\n", paused_ ? "paused by request before" : "goes on at",
                 time_of_day(clock_, clock_.minute_of(pace.tick)).c_str());
    drawn_ = 0;
  }
}

std::function<void(const TickRecord&)> shown_day(const Scenario& scenario, bool quiet) {
  if (quiet) {
    return {};
  }
  return [progress = std::make_shared<DayProgress>(scenario)](const TickRecord& record) { progress->show(record); };
}

}  // namespace evbal
