#include "common/error.hpp"
#include "experiments/study/design/page.hpp"
#include "experiments/study/design/study_file.hpp"

#include <algorithm>

namespace evbal {
namespace {

using Words = std::vector<std::string>;

/// What a page may speak of.
struct Names {
  Words variants;
  Words metrics;
};

std::string known(const YamlValue& word, const char* what, const Words& words) {
  if (std::find(words.begin(), words.end(), word.text()) == words.end()) {
    throw word.error("`" + word.text() + "` is no " + what + did_you_mean(word.text(), words));
  }
  return word.text();
}

Words known_items(const YamlValue& list, const char* what, const Words& words) {
  Words items;
  for (const auto& item : distinct_items(list)) {
    items.push_back(known(item, what, words));
  }
  return items;
}

CompareSection read_compare(YamlMap& map, const Names& names) {
  CompareSection section;
  section.variants = known_items(map.require("variants"), "variant", names.variants);
  section.against = known_items(map.require("against"), "variant", names.variants);
  section.metrics = known_items(map.require("metrics"), "metric", names.metrics);
  if (const auto at = map.find("at")) {
    section.at = known(*at, "metric", names.metrics);
  }
  if (const auto aims = map.find("aims")) {
    YamlMap given(*aims);
    for (const auto& metric : given.keys()) {
      const YamlValue aim = given.require(metric);
      if (std::find(section.metrics.begin(), section.metrics.end(), metric) == section.metrics.end()) {
        throw aim.error("`" + metric + "` is not compared here; name it under `metrics` too");
      }
      section.aims[metric] = aim.number();
    }
  }
  return section;
}

FrontsSection read_fronts(YamlMap& map, const Names& names) {
  const auto metrics = map.find("metrics");
  const auto at = map.find("at");
  return {known_items(map.require("variants"), "variant", names.variants),
          known_items(map.require("against"), "variant", names.variants),
          metrics ? known_items(*metrics, "metric", names.metrics) : Words{"lost"},
          at ? known(*at, "metric", names.metrics) : "idle_km"};
}

MeansSection read_means(YamlMap& map, const Names& names) {
  return {known_items(map.require("variants"), "variant", names.variants),
          known_items(map.require("metrics"), "metric", names.metrics)};
}

CorrelateSection read_correlate(YamlMap& map, const Names& names) {
  return {known_items(map.require("variants"), "variant", names.variants),
          known_items(map.require("metrics"), "metric", names.metrics),
          known(map.require("with"), "metric", names.metrics)};
}

SettingsSection read_settings(YamlMap& map, const Names& names) {
  return {known_items(map.require("variants"), "variant", names.variants)};
}

/// The section's table of one kind, if it has one.
template <class Read>
auto table_of(YamlMap& map, const char* kind, const Read& read, const Names& names) {
  const auto value = map.find(kind);
  std::optional<std::invoke_result_t<Read, YamlMap&, const Names&>> section;
  if (value) {
    YamlMap keys(*value);
    section = read(keys, names);
    keys.finish();
  }
  return section;
}

std::string text_of(YamlMap& map) {
  const auto text = map.find("text");
  return text ? text->paragraphs() : "";
}

PageSection read_section(const YamlValue& value, const Names& names) {
  YamlMap map(value);
  PageSection section{.title = map.require("title").text(), .text = text_of(map)};
  section.compare = table_of(map, "compare", read_compare, names);
  section.fronts = table_of(map, "fronts", read_fronts, names);
  section.means = table_of(map, "means", read_means, names);
  section.correlate = table_of(map, "correlate", read_correlate, names);
  section.settings = table_of(map, "settings", read_settings, names);
  map.finish();
  return section;
}

}  // namespace

Page read_page(const YamlValue& value, const std::vector<std::string>& variants) {
  Names names{variants, finished_metrics()};
  YamlMap map(value);
  Page page{.title = map.require("title").text(), .text = text_of(map), .sections = {}};
  if (const auto objective = map.find("objective")) {
    page.objective = read_prices(*objective);
    names.metrics.emplace_back("objective");
  }
  for (const auto& item : distinct_items(map.require("sections"))) {
    page.sections.push_back(read_section(item, names));
  }
  map.finish();
  return page;
}

}  // namespace evbal
