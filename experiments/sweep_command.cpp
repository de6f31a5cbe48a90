#include "experiments/sweep_command.hpp"

#include "common/error.hpp"
#include "common/interrupt.hpp"
#include "common/text_of_file.hpp"
#include "experiments/progress/live_view.hpp"
#include "experiments/record/summary.hpp"
#include "experiments/record/text.hpp"
#include "experiments/record_day.hpp"
#include "experiments/sweep/sweep.hpp"
#include "experiments/sweep/sweep_file.hpp"
#include "experiments/sweep/sweep_origin.hpp"
#include "experiments/sweep/workers.hpp"

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

namespace evbal {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  fs::path sweep;
  int jobs = 0;
  std::string out;
  bool quiet = false;
};

/// The folder of a sweep, held by one process at a time.
class SweepFolder {
 public:
  explicit SweepFolder(fs::path folder) : folder_(std::move(folder)) {
    if (fs::exists(folder_) && !fs::exists(file()) && !(fs::is_directory(folder_) && fs::is_empty(folder_))) {
      throw bad_input("--out: " + folder_.string() + " is there and holds no sweep; give a new one");
    }
    fs::create_directories(folder_);
    lock_ = open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (flock(lock_, LOCK_EX | LOCK_NB) != 0) {
      close(lock_);
      throw bad_input(folder_.string() + ": another `evbal sweep` is at work there; wait for it or give another --out");
    }
  }
  ~SweepFolder() { close(lock_); }
  SweepFolder(const SweepFolder&) = delete;
  SweepFolder& operator=(const SweepFolder&) = delete;

  const fs::path& path() const { return folder_; }
  fs::path file() const { return folder_ / "sweep.sqlite"; }

 private:
  fs::path folder_;
  int lock_ = -1;
};

std::string label(const SweptDay& day) {
  std::string text = day.variant;
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

/// Reads every scenario, so that what is wrong is refused before any work is done.
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

void play(const Sweep& sweep, const std::vector<std::string>& keys, const fs::path& file, const Arguments& arguments) {
  const std::vector<std::size_t> days = to_do(keys, begin_sweep(file, sweep, keys));
  SweepProgress progress(keys.size(), days.size(), arguments.quiet);
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
  work_through(days, arguments.jobs > 0 ? arguments.jobs : cores, play_one, note);
  if (!failed.empty()) {
    throw run_failed("days that failed, to be played by the next `evbal sweep`:" + failed);
  }
}

void sweep(const Arguments& arguments) {
  catch_interrupts();
  const Sweep sweep = read_sweep(arguments.sweep);
  const std::vector<std::string> keys = keys_of(sweep);
  const SweepFolder folder(arguments.out.empty() ? fs::path("runs") / arguments.sweep.stem() : fs::path(arguments.out));
  for (const char* csv : {"days.csv", "steps.csv"}) {
    fs::remove(folder.path() / csv);
  }
  play(sweep, keys, folder.file(), arguments);
  const SweptDay& first = sweep.days.front();
  note_origin(folder.file(), {.file = arguments.sweep.string(),
                              .text = text_of_file(arguments.sweep),
                              .scenario = resolved_yaml(scenario_of(first), first.controller)});
  write_file(folder.path() / "steps.csv", swept_steps_csv(folder.file()));
  write_file(folder.path() / "days.csv", swept_days_csv(folder.file()));
  std::printf("%s\n", (folder.path() / "days.csv").c_str());
}

}  // namespace

void add_sweep_command(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("sweep", "Play the days of a sweep that are not played yet");
  command->add_option("SWEEP", arguments->sweep, "Sweep file (YAML)")->required();
  command->add_option("--jobs", arguments->jobs, "Days at a time; otherwise one a core")->check(CLI::PositiveNumber);
  command->add_option("--out", arguments->out, "Directory, new or of this sweep; otherwise one under runs/");
  command->add_flag("--quiet", arguments->quiet, "Without progress");
  command->callback([arguments] { sweep(*arguments); });
}

}  // namespace evbal
