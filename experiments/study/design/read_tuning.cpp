#include "common/yaml.hpp"
#include "experiments/study/design/study_file.hpp"
#include "experiments/study/design/tuning.hpp"

#include <algorithm>
#include <limits>

namespace evbal {
namespace {

constexpr std::size_t most_axes = 6;
constexpr int quick_candidates = 4;

SearchAxis read_axis(const std::string& path, const YamlValue& value) {
  refuse_path(value, path);
  if (value.is_list()) {
    return {.path = path, .choices = distinct_items(value)};
  }
  YamlMap range(value);
  SearchAxis axis{.path = path, .from = range.require("from").number(), .to = range.require("to").number()};
  const auto least = range.find("least");
  const auto most = range.find("most");
  range.finish();
  if (axis.from <= 0.0 || axis.to <= axis.from) {
    throw value.error("is no range; give `{from: 1, to: 100}`, both above 0, or a list of values");
  }
  axis.least = least ? least->number(std::numeric_limits<double>::min(), axis.from) : 0.0;
  axis.most = most ? most->number(axis.to, std::numeric_limits<double>::max()) : axis.most;
  return axis;
}

Tunable read_tunable(const YamlValue& value) {
  YamlMap map(value);
  Tunable variant;
  variant.controller = read_chosen(map);
  const auto name = map.find("name");
  variant.name = name ? plain_name(*name) : variant.controller.name;
  if (const auto given = map.find("settings")) {
    YamlMap settings(*given);
    for (const auto& path : settings.keys()) {
      variant.settings.push_back({path, settings.require(path)});
      refuse_path(variant.settings.back().value, path);
    }
  }
  YamlMap search(map.require("search"));
  map.finish();
  for (const auto& path : search.keys()) {
    variant.search.push_back(read_axis(path, search.require(path)));
  }
  if (variant.search.empty() || variant.search.size() > most_axes) {
    throw search.value().error("give 1 to " + std::to_string(most_axes) + " settings to search");
  }
  return variant;
}

/// What is tuned on test days would be told what it is examined on; what was tuned elsewhere is not tuned here.
void refuse_what_is_not_tuned_on(const Replications& replications) {
  for (const auto& name : replications.scenarios()) {
    if (const auto& other = replications.tuned_as(name)) {
      throw other->error("a scenario that takes what was tuned for another one is not tuned itself; leave it out here");
    }
    const City city = read_scenario(replications.of(name).front().yaml).world.city;
    for (const auto& day : replications.days_of(name)) {
      if (std::find(city.train_days.begin(), city.train_days.end(), day.text()) == city.train_days.end()) {
        throw day.error("`" + day.text() + "` is no training day of " + city.name +
                        did_you_mean(day.text(), city.train_days) + "; tune on its training days only, from " +
                        city.train_days.front() + " to " + city.train_days.back());
      }
    }
  }
}

}  // namespace

Tuning read_tuning(const std::filesystem::path& file, bool quick) {
  YamlMap map(YamlValue::load(file));
  map.require("schema").integer(1, 1);
  Tuning tuning{.replications = Replications(map)};
  refuse_what_is_not_tuned_on(tuning.replications);
  tuning.objective = read_prices(map.require("objective"));
  tuning.candidates = map.require("candidates").integer(2, 1024);
  tuning.variants = read_variants(map.require("variants"), read_tunable);
  map.finish();
  if (quick) {
    tuning.replications.cut(1, 1);
    tuning.candidates = std::min(tuning.candidates, quick_candidates);
  }
  return tuning;
}

}  // namespace evbal
