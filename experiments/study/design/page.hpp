#pragma once

#include "common/yaml.hpp"
#include "experiments/study/design/prices.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// What a sweep is asked, and the page that answers (docs/sweeps.md): text from the file, every number from its days.
namespace evbal {

/// The one row of a section that decides what it asks, named before its days are played; all others are exploratory.
struct PrimaryEndpoint {
  std::string scenario;  ///< its name
  std::string faults;    ///< name of the schedule
  std::string variant;   ///< by name
  std::string against;   ///< variant, by name
  std::string metric;    ///< by name
};

/// Variants side by side, paired, each against each reference.
struct CompareSection {
  std::vector<std::string> variants;         ///< by name
  std::vector<std::string> against;          ///< variants, by name
  std::vector<std::string> metrics;          ///< by name
  std::optional<std::string> at;             ///< metric at whose equal values their fronts are compared
  std::map<std::string, double> aims{};      ///< by metric, in per cent: reached if the difference is as low
  std::optional<PrimaryEndpoint> primary{};  ///< of a page's section there is one at most
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

/// A page of answers that a sweep ends with.
struct Page {
  std::string title;  ///< heading
  /// Markdown.
  std::string text;
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

}  // namespace evbal
