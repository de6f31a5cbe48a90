#include "common/error.hpp"
#include "experiments/sweep/occasions.hpp"
#include "experiments/sweep/page.hpp"

#include <algorithm>

namespace evbal {
namespace {

using Words = std::vector<std::string>;

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

CompareSection read_compare(YamlMap& map, const Words& variants) {
  CompareSection section;
  section.variants = known_items(map.require("variants"), "variant", variants);
  section.against = known_items(map.require("against"), "variant", variants);
  section.metrics = known_items(map.require("metrics"), "metric", finished_metrics());
  if (const auto at = map.find("at")) {
    section.at = known(*at, "metric", finished_metrics());
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

MeansSection read_means(YamlMap& map, const Words& variants) {
  return {known_items(map.require("variants"), "variant", variants),
          known_items(map.require("metrics"), "metric", finished_metrics())};
}

CorrelateSection read_correlate(YamlMap& map, const Words& variants) {
  return {known_items(map.require("variants"), "variant", variants),
          known_items(map.require("metrics"), "metric", finished_metrics()),
          known(map.require("with"), "metric", finished_metrics())};
}

SettingsSection read_settings(YamlMap& map, const Words& variants) {
  return {known_items(map.require("variants"), "variant", variants)};
}

/// The section's table of one kind, if it has one.
template <class Read>
auto table_of(YamlMap& map, const char* kind, const Read& read, const Words& variants) {
  const auto value = map.find(kind);
  std::optional<std::invoke_result_t<Read, YamlMap&, const Words&>> section;
  if (value) {
    YamlMap keys(*value);
    section = read(keys, variants);
    keys.finish();
  }
  return section;
}

std::string text_of(YamlMap& map) {
  const auto text = map.find("text");
  return text ? text->text() : "";
}

PageSection read_section(const YamlValue& value, const Words& variants) {
  YamlMap map(value);
  PageSection section{.title = map.require("title").text(), .text = text_of(map)};
  section.compare = table_of(map, "compare", read_compare, variants);
  section.means = table_of(map, "means", read_means, variants);
  section.correlate = table_of(map, "correlate", read_correlate, variants);
  section.settings = table_of(map, "settings", read_settings, variants);
  map.finish();
  return section;
}

}  // namespace

Page read_page(const YamlValue& value, const Words& variants) {
  YamlMap map(value);
  Page page{.title = map.require("title").text(), .text = text_of(map), .sections = {}};
  for (const auto& item : distinct_items(map.require("sections"))) {
    page.sections.push_back(read_section(item, variants));
  }
  map.finish();
  return page;
}

}  // namespace evbal
