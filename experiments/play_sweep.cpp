#include "experiments/play_sweep.hpp"

#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "experiments/progress/live_view.hpp"
#include "experiments/record/summary.hpp"
#include "experiments/record_day.hpp"
#include "experiments/sweep/sweep_file.hpp"
#include "experiments/sweep/workers.hpp"

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace evbal {
namespace {

namespace fs = std::filesystem;

std::string label(const SweptDay& day) {
  std::string text = day.scenario + " " + day.variant;
  for (const auto& [path, value] : day.settings) {
    text.append(" ").append(path).append("=").append(value);
  }
  return text + (day.faults.empty() ? "" : " " + day.faults) + " " + day.day + " seed " + std::to_string(day.seed);
}

/// A line on stderr for every day that ends; on a terminal one line that renews itself.
class SweepProgress {
 public:
  SweepProgress(std::size_t all, std::size_t to_do, bool quiet) : all_(all), to_do_(to_do), quiet_(quiet) {}
  ~SweepProgress() {
    if (line_open_) {
      std::fputs("\n", stderr);
    }
  }
  SweepProgress(const SweepProgress&) = delete;
  SweepProgress& operator=(const SweepProgress&) = delete;

  void show(const std::string& ended) {
    ++done_;
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double left = spent / static_cast<double>(done_) * static_cast<double>(to_do_ - done_);
    if (!quiet_) {
      line_open_ = isatty(STDERR_FILENO) == 1;
      std::fprintf(stderr, "%s%zu/%zu  %s  %s left%s", line_open_ ? "\r\033[K" : "", all_ - to_do_ + done_, all_,
                   ended.c_str(), shown_seconds(left).c_str(), line_open_ ? "" : "\n");
    }
  }

 private:
  std::size_t all_;
  std::size_t to_do_;
  bool quiet_;
  std::size_t done_ = 0;
  bool line_open_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The first day of each key that has no result.
std::vector<std::size_t> to_do(const std::vector<std::string>& keys, std::set<std::string> finished) {
  std::vector<std::size_t> days;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (finished.insert(keys[i]).second) {
      days.push_back(i);
    }
  }
  return days;
}

}  // namespace

void add_playing_options(CLI::App& command, Playing& playing) {
  command.add_option("--jobs", playing.jobs, "Days at a time; otherwise one a core")->check(CLI::PositiveNumber);
  command.add_flag("--quiet", playing.quiet, "Without progress");
}

SweepFolder::SweepFolder(fs::path folder) : folder_(std::move(folder)) {
  if (fs::exists(folder_) && !fs::exists(file()) && !(fs::is_directory(folder_) && fs::is_empty(folder_))) {
    throw bad_input("--out: " + folder_.string() + " is there and holds no sweep; give a new one");
  }
  fs::create_directories(folder_);
  lock_ = open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    close(lock_);
    throw bad_input(folder_.string() + ": another evbal is at work there; wait for it or give another --out");
  }
}

SweepFolder::~SweepFolder() {
  close(lock_);
}

std::vector<std::string> keys_of(const Sweep& sweep) {
  std::vector<std::string> keys;
  for (const auto& day : sweep.days) {
    const Scenario scenario = scenario_of(day);
    if (!scenario.planning.coordinator.empty()) {
      throw bad_input("coordinator `" + shown(scenario.planning.coordinator) +
                      "`: takes part over the bus, without which sweeps play their days; use `evbal run`");
    }
    keys.push_back(text_digest(resolved_yaml(scenario, day.controller)));
    check_interrupt();
  }
  return keys;
}

void play_sweep(const Sweep& sweep, const std::vector<std::string>& keys, const SweepFolder& folder,
                const Playing& playing) {
  const fs::path file = folder.file();
  const std::vector<std::size_t> days = to_do(keys, begin_sweep(file, sweep, keys));
  SweepProgress progress(keys.size(), days.size(), playing.quiet);
  std::string failed;
  const auto play_one = [&](std::size_t i) {
    const Scenario scenario = scenario_of(sweep.days[i]);
    add_result(file, keys[i], scenario.world.clock, play_day(scenario));
  };
  const auto note = [&](std::size_t i, const std::string& complaint) {
    failed += complaint.empty() ? "" : "\n  " + label(sweep.days[i]) + ": " + complaint;
    progress.show(label(sweep.days[i]) + (complaint.empty() ? "" : ": failed"));
  };
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  work_through(days, playing.jobs > 0 ? playing.jobs : cores, play_one, note);
  if (!failed.empty()) {
    throw run_failed("days that failed, to be played by the same command again:" + failed);
  }
}

}  // namespace evbal
