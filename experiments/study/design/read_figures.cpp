#include "common/error.hpp"
#include "common/suggestion.hpp"
#include "experiments/study/design/page_names.hpp"
#include "experiments/study/design/study_file.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace evbal {
namespace {

using Texts = std::vector<std::string>;

constexpr std::array figure_kinds = {
    std::pair("fronts", FigureKind::fronts),     std::pair("claims", FigureKind::claims),
    std::pair("forest", FigureKind::forest),     std::pair("slopes", FigureKind::slopes),
    std::pair("ablation", FigureKind::ablation), std::pair("map", FigureKind::map),
    std::pair("bars", FigureKind::bars)};

Texts items_or_all(YamlMap& map, const char* key, const char* what, const Texts& all) {
  const auto given = map.find(key);
  return given ? read_known_items(*given, what, all) : all;
}

/// The one schedule of faults that a figure is of.
std::string figure_faults(YamlMap& map, const KnownNames& names) {
  if (const auto given = map.find("faults")) {
    return read_known(*given, "faults", names.faults);
  }
  if (names.faults.size() > 1) {
    throw map.value().error("a figure is of one schedule of faults; say which `faults` it is of");
  }
  return names.faults.front();
}

void read_bars(PageFigure& figure, YamlMap& map, const KnownNames& names) {
  figure.variants = read_known_items(map.require("variants"), "variant", names.variants);
  figure.metrics = read_known_items(map.require("metrics"), "metric", names.metrics);
  if (const auto of = map.find("of")) {
    figure.of = read_known(*of, "metric", names.metrics);
  }
  figure.scenarios = items_or_all(map, "scenarios", "scenario", names.scenarios);
  figure.faults = items_or_all(map, "faults", "faults", names.faults);
}

/// What the keys below the kind of any other figure say.
void read_shown(PageFigure& figure, YamlMap& map, const KnownNames& names) {
  const bool several = figure.kind == FigureKind::fronts || figure.kind == FigureKind::ablation;
  figure.variants = several ? read_known_items(map.require("variants"), "variant", names.variants)
                            : Texts{read_known(map.require("variant"), "variant", names.variants)};
  if (figure.kind == FigureKind::ablation) {
    figure.against = read_known_items(map.require("against"), "variant", names.variants);
  } else if (!several) {
    figure.against = {read_known(map.require("against"), "variant", names.variants)};
  }
  if (figure.kind == FigureKind::map) {
    figure.scenarios = items_or_all(map, "rows", "scenario", names.scenarios);
    figure.faults = items_or_all(map, "columns", "faults", names.faults);
  } else {
    figure.scenarios = items_or_all(map, "scenarios", "scenario", names.scenarios);
    figure.faults = {figure_faults(map, names)};
  }
}

PageFigure read_figure(const YamlValue& value, const KnownNames& names) {
  YamlMap map(value);
  PageFigure figure{.caption = map.require("caption").paragraphs()};
  int kinds = 0;
  for (const auto& [key, kind] : figure_kinds) {
    const auto shown = map.find(key);
    if (!shown) {
      continue;
    }
    ++kinds;
    figure.kind = kind;
    if (kind == FigureKind::forest) {
      read_known(*shown, "thing for a forest plot; `primaries` are", {"primaries"});
      continue;
    }
    YamlMap keys(*shown);
    (kind == FigureKind::bars ? read_bars : read_shown)(figure, keys, names);
    keys.finish();
  }
  map.finish();
  if (kinds != 1) {
    throw value.error(
        "a figure shows one thing; give one of `fronts`, `claims`, `forest`, `slopes`, `ablation`, `map`, `bars`");
  }
  return figure;
}

VerdictQuestion read_question(const YamlValue& value, const KnownNames& names) {
  YamlMap map(value);
  VerdictQuestion asked{.question = map.require("question").text(), .fronts = {}};
  const YamlValue fronts = map.require("fronts");
  for (const auto& one : fronts.is_list() ? distinct_items(fronts) : std::vector<YamlValue>{fronts}) {
    YamlMap keys(one);
    asked.fronts.push_back(read_fronts(keys, names));
    keys.finish();
    if (asked.fronts.back().primaries.empty()) {
      throw one.error("primary endpoints decide a question; name them, such as `primary: {scenarios: [...]}`");
    }
    const std::string& metric = asked.fronts.back().primaries.front().metric;
    if (metric != "lost" && metric != "idle_km") {
      throw one.error("a verdict is on `lost` or `idle_km`, of which less is better, not on `" + metric + "`");
    }
  }
  map.finish();
  return asked;
}

}  // namespace

std::vector<VerdictQuestion> read_verdict(const YamlValue& value, const KnownNames& names) {
  std::vector<VerdictQuestion> verdict;
  for (const auto& item : distinct_items(value)) {
    verdict.push_back(read_question(item, names));
  }
  return verdict;
}

std::vector<PageFigure> read_figures(const YamlValue& value, const KnownNames& names) {
  std::vector<PageFigure> figures;
  for (const auto& item : distinct_items(value)) {
    figures.push_back(read_figure(item, names));
  }
  return figures;
}

std::map<std::string, std::string> read_names(const YamlValue& value, const KnownNames& names) {
  Texts all = names.variants;
  all.insert(all.end(), names.scenarios.begin(), names.scenarios.end());
  all.insert(all.end(), names.faults.begin(), names.faults.end());
  YamlMap map(value);
  std::map<std::string, std::string> words;
  for (const auto& name : map.keys()) {
    const YamlValue text = map.require(name);
    if (std::find(all.begin(), all.end(), name) == all.end()) {
      throw text.error("`" + name + "` is no variant, scenario or schedule of faults" + did_you_mean(name, all));
    }
    words[name] = text.text();
  }
  return words;
}

}  // namespace evbal
