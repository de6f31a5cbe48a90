#include "tools/evbal/sweep_bounds.hpp"

#include "common/error.hpp"
#include "common/workers.hpp"
#include "experiments/study/executors/play_days.hpp"
#include "tools/evbal/kept_bound.hpp"

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace evbal {

void bound_days(const Sweep& sweep, const PlayingOptions& options) {
  if (sweep.bound.prices.empty()) {
    return;
  }
  const std::vector<std::size_t> days = days_to_bound(sweep, sweep.bound);
  const auto work = [&](std::size_t i) { kept_bound_alone(scenario_of(sweep.days[i]), sweep.bound.prices); };
  std::size_t ended = 0;
  std::string failed;
  work_through(days, options.playing.jobs > 0 ? options.playing.jobs : cores(), work,
               [&](std::size_t i, const std::string& complaint) {
                 const SweptDay& day = sweep.days[i];
                 const std::string label = day.scenario + " " + day.day + " seed " + std::to_string(day.seed);
                 failed += complaint.empty() ? "" : "\n  " + label + ": " + complaint;
                 ++ended;
                 if (!options.quiet) {
                   std::fprintf(stderr, "bound %zu/%zu  %s\n", ended, days.size(), label.c_str());
                 }
               });
  if (!failed.empty()) {
    throw run_failed("days whose bound failed, to be computed by the same command again:" + failed);
  }
}

}  // namespace evbal
