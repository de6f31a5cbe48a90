#include "experiments/search/searched_days.hpp"

#include "experiments/study/design/sweep.hpp"
#include "experiments/study/store/sweep_file.hpp"

#include <algorithm>
#include <utility>

namespace evbal {
namespace {

std::string label_of(const Trial& trial) {
  return trial.number == 0 ? "without-faults" : trial.stage + "-" + std::to_string(trial.number);
}

}  // namespace

SearchedDays::SearchedDays(const Scenario& scenario, const Ingredients& ingredients, const SweepFolder& folder,
                           Playing playing, std::size_t expected)
    : scenario_(scenario),
      ingredients_(ingredients),
      folder_(folder),
      playing_(std::move(playing)),
      expected_(expected) {}

Scenario SearchedDays::with(const Picks& picks) const {
  Scenario scenario = scenario_;
  scenario.schedule = schedule_of(picks, ingredients_);
  scenario.draws = {scenario.schedule};
  return scenario;
}

std::vector<double> SearchedDays::values(const std::vector<Trial>& trials, const std::string& metric) {
  const std::string& controller = scenario_.planning.controller;
  Sweep sweep;
  std::vector<std::string> keys;
  for (const auto& trial : trials) {
    Scenario day = with(trial.picks);
    day.expect.clear();  // no part of what happens: results stay when it is changed
    sweep.days.push_back({.variant = controller,
                          .controller = controller,
                          .faults = label_of(trial),
                          .day = day.world.day.date,
                          .seed = day.world.seed,
                          .yaml = YamlValue::parse(resolved_yaml(day, controller), label_of(trial))});
    keys.push_back(keys_.of(day, controller));
  }
  Playing playing = playing_;
  if (playing_.on_day_ended) {
    playing.on_day_ended = [&](DayEnded day) {
      day.ended += asked_;
      day.all = std::max(expected_, asked_ + trials.size());
      playing_.on_day_ended(day);
    };
  }
  refuse_failed(play_sweep(sweep, keys, folder_, playing), sweep);
  asked_ += trials.size();
  used_.insert(used_.end(), keys.begin(), keys.end());
  std::vector<double> values;
  for (const auto& day : read_finished(folder_.file())) {
    values.push_back(day.totals.at(metric));
  }
  return values;
}

}  // namespace evbal
