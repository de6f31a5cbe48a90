#include "experiments/study/statistics/known_names.hpp"

#include "common/error.hpp"
#include "common/suggestion.hpp"

#include <set>

namespace evbal {

void expect_metric(const std::string& name, const std::vector<FinishedDay>& days) {
  if (!days.front().totals.contains(name)) {
    std::vector<std::string> names;
    for (const auto& [known, value] : days.front().totals) {
      names.push_back(known);
    }
    throw bad_input("`" + name + "` is no metric" + did_you_mean(name, names) + "; see docs/metrics.md");
  }
}

void expect_variant(const std::string& name, const std::vector<FinishedDay>& days) {
  std::set<std::string> variants;
  for (const auto& day : days) {
    variants.insert(day.variant);
  }
  if (!variants.contains(name)) {
    throw bad_input("no variant is called `" + name + "`" +
                    did_you_mean(name, std::vector<std::string>(variants.begin(), variants.end())));
  }
}

}  // namespace evbal
