#include "experiments/study/executors/play_into.hpp"

#include "experiments/run/record_day.hpp"
#include "experiments/study/store/sweep_file.hpp"

#include <chrono>

namespace evbal {

void play_into(const std::filesystem::path& file, const std::string& key, const Scenario& scenario) {
  const auto start = std::chrono::steady_clock::now();
  const DayResult result = play_day(scenario);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  add_result(file, key, scenario.world.clock, result);
  note_seconds(file, key, took.count());
}

}  // namespace evbal
