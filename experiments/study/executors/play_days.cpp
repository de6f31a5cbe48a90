#include "experiments/study/executors/play_days.hpp"

#include "experiments/study/store/sweep_file.hpp"

#include <algorithm>
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
                    const OnDayEnded& on_day_ended, const Work& work) {
  const std::vector<std::size_t> days = to_do(keys, begin_sweep(file, sweep, keys));
  std::size_t ended = keys.size() - days.size();
  std::string failed;
  work(days, [&](std::size_t i, const std::string& complaint) {
    const std::string day = label(sweep.days[i]);
    failed += complaint.empty() ? "" : "\n  " + day + ": " + complaint;
    ++ended;
    if (on_day_ended) {
      on_day_ended({.day = day, .failed = !complaint.empty(), .ended = ended, .all = keys.size()});
    }
  });
  return failed;
}

}  // namespace evbal
