#include "experiments/study/design/day_filter.hpp"

#include "common/error.hpp"
#include "common/suggestion.hpp"
#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/design/sweep.hpp"

namespace evbal {
namespace {

template <class Day>
struct FilteredName {
  const char* option;
  std::vector<std::string> DayFilter::*asked;
  std::string Day::*name;
};

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void expect_names(const std::string& option, const std::vector<std::string>& asked,
                  const std::vector<std::string>& there) {
  for (const auto& name : asked) {
    if (!holds(there, name)) {
      throw bad_input(option + ": `" + name + "` is not in the sweep" + did_you_mean(name, there) + "; there is " +
                      listed(there));
    }
  }
}

template <class Day>
std::vector<std::size_t> positions_of(const DayFilter& filter, const std::vector<Day>& days) {
  const FilteredName<Day> names[] = {{"--scenario", &DayFilter::scenarios, &Day::scenario},
                                     {"--faults", &DayFilter::faults, &Day::faults},
                                     {"--variant", &DayFilter::variants, &Day::variant},
                                     {"--days", &DayFilter::days, &Day::day}};
  std::vector<bool> chosen(days.size(), true);
  for (const auto& [option, asked, name] : names) {
    std::vector<std::string> there;
    for (std::size_t i = 0; i < days.size(); ++i) {
      if (!holds(there, days[i].*name)) {
        there.push_back(days[i].*name);
      }
      chosen[i] = chosen[i] && ((filter.*asked).empty() || holds(filter.*asked, days[i].*name));
    }
    expect_names(option, filter.*asked, there);
  }
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < days.size(); ++i) {
    if (chosen[i]) {
      positions.push_back(i);
    }
  }
  if (positions.empty()) {
    throw bad_input("no day of the sweep has all of these: --scenario, --faults, --variant and --days");
  }
  return positions;
}

template std::vector<std::size_t> positions_of(const DayFilter&, const std::vector<FinishedDay>&);
template std::vector<std::size_t> positions_of(const DayFilter&, const std::vector<SweptDay>&);

}  // namespace evbal
