#include "experiments/search/path_csv.hpp"

#include "common/decimal.hpp"
#include "common/table_text.hpp"
#include "experiments/search/described.hpp"

#include <algorithm>

namespace evbal {

std::string path_csv(const std::vector<Trial>& trials, const Ingredients& ingredients) {
  std::string text = csv_row({"trial", "stage", "parent", "change", "harm", "most_harm", "faults", "schedule"});
  double most = trials.empty() ? 0.0 : trials.front().harm;
  for (const auto& trial : trials) {
    most = std::max(most, trial.harm);
    text += csv_row({std::to_string(trial.number), trial.stage, trial.parent == 0 ? "" : std::to_string(trial.parent),
                     trial.change, decimal(trial.harm), decimal(most), std::to_string(trial.picks.size()),
                     described(schedule_of(trial.picks, ingredients), ingredients.context.clock)});
  }
  return text;
}

}  // namespace evbal
