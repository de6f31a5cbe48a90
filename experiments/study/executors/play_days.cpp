#include "experiments/study/executors/play_days.hpp"

#include "common/workers.hpp"
#include "experiments/progress/live_view.hpp"
#include "experiments/study/store/sweep_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>
#include <thread>

namespace evbal {
namespace {

std::string label(const SweptDay& day) {
  std::string text = (day.scenario.empty() ? "" : day.scenario + " ") + day.variant;
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

int cores() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

std::string do_days(const Sweep& sweep, const std::vector<std::string>& keys, const std::filesystem::path& file,
                    bool quiet, const std::function<void(const std::vector<std::size_t>&, const Done&)>& work) {
  const std::vector<std::size_t> days = to_do(keys, begin_sweep(file, sweep, keys));
  SweepProgress progress(keys.size(), days.size(), quiet);
  std::string failed;
  work(days, [&](std::size_t i, const std::string& complaint) {
    failed += complaint.empty() ? "" : "\n  " + label(sweep.days[i]) + ": " + complaint;
    progress.show(label(sweep.days[i]) + (complaint.empty() ? "" : ": failed"));
  });
  return failed;
}

std::string play_days(const Sweep& sweep, const std::vector<std::string>& keys, const std::filesystem::path& file,
                      const Labour& labour, const std::function<void(std::size_t)>& play) {
  return do_days(sweep, keys, file, labour.quiet, [&](const std::vector<std::size_t>& days, const Done& done) {
    work_through(days, labour.at_a_time, play, done);
  });
}

}  // namespace evbal
