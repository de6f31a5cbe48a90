#pragma once

#include "common/yaml.hpp"
#include "experiments/study/design/prices.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// What a sweep is asked, and the page that answers (docs/sweeps.md): text from the file, every number from its days.
namespace evbal {

/// A row that decides what a section asks, named before its days are played; all others are exploratory.
struct PrimaryEndpoint {
  std::string scenario;  ///< its name
  std::string faults;    ///< name of the schedule
  std::string variant;   ///< by name
  std::string against;   ///< variant, by name
  std::string metric;    ///< by name

  /// Whether all of these are the same.
  bool operator==(const PrimaryEndpoint&) const = default;
};

/// Variants side by side, paired, each against each reference.
struct CompareSection {
  std::vector<std::string> variants;         ///< by name
  std::vector<std::string> against;          ///< variants, by name
  std::vector<std::string> metrics;          ///< by name
  std::optional<std::string> at;             ///< metric at whose equal values their fronts are compared
  std::map<std::string, double> aims{};      ///< by metric, in per cent: reached if the difference is as low
  std::vector<PrimaryEndpoint> primaries{};  ///< one a scenario, otherwise alike
};

/// Means over days, with intervals by t.
struct MeansSection {
  std::vector<std::string> variants;  ///< by name
  std::vector<std::string> metrics;   ///< by name
};

/// Spearman's rank correlation of metrics with another one, over all points of the variants on one day and seed.
struct CorrelateSection {
  std::vector<std::string> variants;  ///< by name
  std::vector<std::string> metrics;   ///< by name
  std::string with;                   ///< metric that they are correlated with
};

/// The settings of variants, as tuned.
struct SettingsSection {
  std::vector<std::string> variants;  ///< by name
};

/// A heading, its text, and at most one table.
struct PageSection {
  std::string title;  ///< heading
  /// Markdown.
  std::string text;
  std::optional<CompareSection> compare{};      ///< variants against others
  std::optional<CompareSection> fronts{};       ///< variants' fronts against those of others
  std::optional<MeansSection> means{};          ///< of metrics
  std::optional<CorrelateSection> correlate{};  ///< metrics with one metric
  std::optional<SettingsSection> settings{};    ///< as tuned
};

/// What a page is asked before its days are played; the primary endpoints of its comparisons decide.
struct VerdictQuestion {
  std::string question;                ///< in words
  std::vector<CompareSection> fronts;  ///< at least one, each with primary endpoints
};

/// What a figure shows.
enum class FigureKind {
  fronts,    ///< lost passengers against idle km, a panel a scenario, with the bound
  claims,    ///< the paper's three claims beside what came out here
  forest,    ///< the primary endpoints with their intervals
  slopes,    ///< day by day from one variant to another
  ablation,  ///< several variants against others, with intervals
  map,       ///< one variant against another, a cell a scenario and schedule of faults
  bars       ///< metrics of variants, a group of bars a scenario and schedule of faults
};

/// A figure of a page.
struct PageFigure {
  FigureKind kind = FigureKind::fronts;  ///< what it shows
  std::string caption;                   ///< what there is to see
  std::vector<std::string> variants{};   ///< by name; none of a forest
  std::vector<std::string> against{};    ///< variants, by name; none of fronts, of a forest and of bars
  std::vector<std::string> scenarios{};  ///< by name
  std::vector<std::string> faults{};     ///< names of schedules; one, but for a map and bars
  std::vector<std::string> metrics{};    ///< of bars, by name
  std::optional<std::string> of{};       ///< of bars: metric that they are shares of
};

/// A page of answers that a sweep ends with.
struct Page {
  std::string title;  ///< heading
  /// Markdown.
  std::string text;
  /// Markdown: what is asked, for readers who know nothing of it.
  std::string introduction{};
  std::map<std::string, std::string> names{};  ///< words for variants, scenarios and schedules of faults, by their name
  std::vector<VerdictQuestion> verdict{};      ///< in their order
  /// Markdown: what was decided after some of the results were known.
  std::string decided_after{};
  std::vector<PageFigure> figures{};  ///< in their order
  Prices objective{};                 ///< makes the metric `objective` of each day; empty: there is none
  std::vector<PageSection> sections;  ///< in their order
};

/// What there is in a sweep that its page may speak of.
struct PageNames {
  std::vector<std::string> variants;   ///< by name
  std::vector<std::string> scenarios;  ///< by name
  std::vector<std::string> faults;     ///< names of the schedules
};

/// Reads a sweep's `page`. Throws Error{bad_input} with file, line, reason and what would be right, also if a section
/// names a variant, scenario or schedule that is not in the sweep.
Page read_page(const YamlValue& value, const PageNames& names);

/// The words for a variant, scenario or schedule of faults: its name where the page has none.
std::string words_for(const Page& page, const std::string& name);

}  // namespace evbal
