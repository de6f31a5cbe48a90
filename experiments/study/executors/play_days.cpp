#include "experiments/study/executors/play_days.hpp"

#include "common/interrupt.hpp"
#include "experiments/study/store/sweep_file.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <thread>

namespace evbal {
namespace {

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

std::string shown(const std::vector<FailedDay>& failed) {
  constexpr std::size_t most = 20;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, failed.size()); ++i) {
    text += "\n  " + failed[i].day + ": " + failed[i].reason;
  }
  return text + (failed.size() > most ? "\n  and " + std::to_string(failed.size() - most) + " more" : "");
}

std::vector<FailedDay> do_days(const Sweep& sweep, const std::vector<std::string>& keys,
                               const std::filesystem::path& file, const OnDayEnded& on_day_ended, const Work& work) {
  const std::vector<std::size_t> days = to_do(keys, begin_sweep(file, sweep, keys));
  std::size_t ended = keys.size() - days.size();
  std::map<std::size_t, std::string> failed;
  const auto do_all = [&](const std::vector<std::size_t>& positions, bool last_time) {
    work(positions, [&](std::size_t i, const std::string& complaint) {
      failed.erase(i);
      if (!complaint.empty()) {
        check_interrupt();  // which may have ended the day
        failed[i] = complaint;
        note_failure(file, keys[i], complaint);
      }
      const bool again = !complaint.empty() && !last_time;
      ended += again ? 0 : 1;
      if (on_day_ended) {
        on_day_ended({.day = label_of(sweep.days[i]),
                      .failed = !complaint.empty(),
                      .again = again,
                      .ended = ended,
                      .all = keys.size()});
      }
    });
  };
  do_all(days, false);
  std::vector<std::size_t> once_more;
  for (const auto& [i, reason] : failed) {
    once_more.push_back(i);
  }
  if (!once_more.empty()) {
    do_all(once_more, true);
  }
  std::vector<FailedDay> failed_twice;
  for (const auto& [i, reason] : failed) {
    failed_twice.push_back({label_of(sweep.days[i]), reason});
  }
  return failed_twice;
}

}  // namespace evbal
