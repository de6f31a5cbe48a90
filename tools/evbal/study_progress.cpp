#include "tools/evbal/study_progress.hpp"

#include "common/version.hpp"
#include "experiments/progress/live_view.hpp"
#include "experiments/study/store/sweep_file.hpp"

#include <unistd.h>

#include <cstdio>

namespace evbal {

StudyProgress::~StudyProgress() {
  if (line_open_) {
    std::fputs("\n", stderr);
  }
}

OnDayEnded StudyProgress::shown_days() {
  return quiet_ ? OnDayEnded{} : [this](const DayEnded& day) { show(day); };
}

void StudyProgress::show(const DayEnded& day) {
  ++shown_;
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double left = spent / static_cast<double>(shown_) * static_cast<double>(day.all - day.ended);
  line_open_ = isatty(STDERR_FILENO) == 1;
  std::fprintf(stderr, "%s%zu/%zu  %s%s  %s left%s", line_open_ ? "\r\033[K" : "", day.ended, day.all, day.day.c_str(),
               day.again    ? ": failed, is tried again"
               : day.failed ? ": failed"
                            : "",
               shown_seconds(left).c_str(), line_open_ ? "" : "\n");
}

void warn_of_other_programs(const std::filesystem::path& file, const std::vector<std::string>& keys) {
  for (const auto& [program, asked_for, others] : played_by_others(file, keys)) {
    if (asked_for > 0) {
      std::fprintf(stderr,
                   "evbal: %d of the days were played by %s, this is %s: they are kept; give another --out to play "
                   "all anew\n",
                   asked_for, program.c_str(), this_program().c_str());
    }
    if (others > 0) {
      std::fprintf(stderr, "evbal: %d other days in %s, played by %s, are not used: this is %s\n", others, file.c_str(),
                   program.c_str(), this_program().c_str());
    }
  }
}

}  // namespace evbal
