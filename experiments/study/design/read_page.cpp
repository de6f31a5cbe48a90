#include "common/error.hpp"
#include "common/suggestion.hpp"
#include "experiments/study/design/page_names.hpp"
#include "experiments/study/design/study_file.hpp"
#include "experiments/study/design/trade.hpp"

#include <algorithm>

namespace evbal {
namespace {

using Words = std::vector<std::string>;

std::string read_at(const YamlValue& at) {
  if (!traded_for(at.text())) {
    throw at.error("`" + at.text() + "` is nothing to compare at" + did_you_mean(at.text(), traded_metrics()) +
                   "; `idle_km` and `lost` are, which controllers trade");
  }
  return at.text();
}

/// A primary endpoint's name of one kind; without one that which is the only one.
std::string read_only(YamlMap& map, const YamlValue& place, const char* key, const Words& names) {
  if (const auto given = map.find(key)) {
    return read_known(*given, key, names);
  }
  if (names.size() > 1) {
    throw place.error("a primary endpoint is one row; say which " + std::string(key) + " it is of");
  }
  return names.front();
}

/// A row a scenario.
std::vector<PrimaryEndpoint> read_primaries(YamlMap& map, const CompareSection& section, const KnownNames& names) {
  const auto value = map.find("primary");
  if (!value) {
    return {};
  }
  YamlMap keys(*value);
  const auto several = keys.find("scenarios");
  const Words scenarios = several ? read_known_items(*several, "scenario", names.scenarios)
                                  : Words{read_only(keys, *value, "scenario", names.scenarios)};
  std::vector<PrimaryEndpoint> primaries;
  for (const auto& scenario : scenarios) {
    primaries.push_back({.scenario = scenario,
                         .faults = read_only(keys, *value, "faults", names.faults),
                         .variant = read_only(keys, *value, "variant", section.variants),
                         .against = read_only(keys, *value, "against", section.against),
                         .metric = read_only(keys, *value, "metric", section.metrics)});
  }
  keys.finish();
  return primaries;
}

CompareSection read_compare(YamlMap& map, const KnownNames& names) {
  CompareSection section;
  section.variants = read_known_items(map.require("variants"), "variant", names.variants);
  section.against = read_known_items(map.require("against"), "variant", names.variants);
  section.metrics = read_known_items(map.require("metrics"), "metric", names.metrics);
  if (const auto at = map.find("at")) {
    section.at = read_at(*at);
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
  section.primaries = read_primaries(map, section, names);
  return section;
}

MeansSection read_means(YamlMap& map, const KnownNames& names) {
  return {read_known_items(map.require("variants"), "variant", names.variants),
          read_known_items(map.require("metrics"), "metric", names.metrics)};
}

CorrelateSection read_correlate(YamlMap& map, const KnownNames& names) {
  return {read_known_items(map.require("variants"), "variant", names.variants),
          read_known_items(map.require("metrics"), "metric", names.metrics),
          read_known(map.require("with"), "metric", names.metrics)};
}

SettingsSection read_settings(YamlMap& map, const KnownNames& names) {
  return {read_known_items(map.require("variants"), "variant", names.variants)};
}

/// The section's table of one kind, if it has one.
template <class Read>
auto table_of(YamlMap& map, const char* kind, const Read& read, const KnownNames& names) {
  const auto value = map.find(kind);
  std::optional<std::invoke_result_t<Read, YamlMap&, const KnownNames&>> section;
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

PageSection read_section(const YamlValue& value, const KnownNames& names) {
  YamlMap map(value);
  PageSection section{.title = map.require("title").text(), .text = text_of(map)};
  section.compare = table_of(map, "compare", read_compare, names);
  section.fronts = table_of(map, "fronts", read_fronts, names);
  section.means = table_of(map, "means", read_means, names);
  section.correlate = table_of(map, "correlate", read_correlate, names);
  section.settings = table_of(map, "settings", read_settings, names);
  map.finish();
  if (section.compare && !section.compare->primaries.empty() && section.fronts && !section.fronts->primaries.empty()) {
    throw value.error("a section has one primary endpoint; make another section of the second");
  }
  return section;
}

}  // namespace

std::string read_known(const YamlValue& word, const char* what, const Words& words) {
  if (std::find(words.begin(), words.end(), word.text()) == words.end()) {
    throw word.error("`" + word.text() + "` is no " + what + did_you_mean(word.text(), words));
  }
  return word.text();
}

Words read_known_items(const YamlValue& list, const char* what, const Words& words) {
  Words items;
  for (const auto& item : distinct_items(list)) {
    items.push_back(read_known(item, what, words));
  }
  return items;
}

CompareSection read_fronts(YamlMap& map, const KnownNames& names) {
  const auto metrics = map.find("metrics");
  const auto at = map.find("at");
  CompareSection section{read_known_items(map.require("variants"), "variant", names.variants),
                         read_known_items(map.require("against"), "variant", names.variants),
                         metrics ? read_known_items(*metrics, "metric", names.metrics) : Words{"lost"},
                         at ? read_at(*at) : "idle_km"};
  section.primaries = read_primaries(map, section, names);
  return section;
}

Page read_page(const YamlValue& value, const PageNames& in_sweep) {
  KnownNames names{in_sweep, finished_metrics()};
  YamlMap map(value);
  Page page{.title = map.require("title").text(), .text = text_of(map), .sections = {}};
  if (const auto objective = map.find("objective")) {
    page.objective = read_prices(*objective);
    if (std::any_of(page.objective.begin(), page.objective.end(),
                    [](const auto& price) { return price.second < 0.0; })) {
      throw objective->error("a page tells its objective as a ratio; give prices that are not negative");
    }
    names.metrics.emplace_back("objective");
  }
  if (const auto words = map.find("names")) {
    page.names = read_names(*words, names);
  }
  if (const auto introduction = map.find("introduction")) {
    page.introduction = introduction->paragraphs();
  }
  if (const auto verdict = map.find("verdict")) {
    page.verdict = read_verdict(*verdict, names);
  }
  if (const auto after = map.find("decided_after")) {
    page.decided_after = after->paragraphs();
  }
  if (const auto figures = map.find("figures")) {
    page.figures = read_figures(*figures, names);
  }
  for (const auto& item : distinct_items(map.require("sections"))) {
    page.sections.push_back(read_section(item, names));
  }
  map.finish();
  return page;
}

std::string words_for(const Page& page, const std::string& name) {
  const auto words = page.names.find(name);
  return words == page.names.end() ? name : words->second;
}

}  // namespace evbal
