#pragma once

#include "experiments/study/executors/play_days.hpp"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// Shows on stderr how far a study of many days has come: a line for every day that ends; on a terminal one line that
/// renews itself.
class StudyProgress {
 public:
  /// Shows nothing if `quiet`.
  explicit StudyProgress(bool quiet) : quiet_(quiet) {}

  /// Ends the line of a terminal.
  ~StudyProgress();
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;

  /// What shows each day that ends, while this object lives; nothing if quiet.
  OnDayEnded shown_days();

 private:
  void show(const DayEnded& day);

  bool quiet_;
  bool line_open_ = false;
  std::size_t shown_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Says on stderr which results in a study's file another version or build of evbal played, and whether they are among
/// the days with these keys. To be called before the study goes on, or at its end by one that does not know its days
/// before.
void warn_of_other_programs(const std::filesystem::path& file, const std::vector<std::string>& keys);

}  // namespace evbal
