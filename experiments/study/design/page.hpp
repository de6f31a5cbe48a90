#pragma once

#include "common/yaml.hpp"
#include "experiments/study/design/prices.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

/// What a sweep is asked, and the page that answers (docs/sweeps.md): text from the file, every number from its days.
namespace evbal {

/// Variants side by side, paired, each against each reference.
struct CompareSection {
  std::vector<std::string> variants;   ///< by name
  std::vector<std::string> against;    ///< variants, by name
  std::vector<std::string> metrics;    ///< by name
  std::optional<std::string> at;       ///< metric at whose equal values they are compared
  std::map<std::string, double> aims;  ///< by metric, in per cent: reached if the difference is as low
};

/// Whole fronts side by side, day by day, each against each reference.
struct FrontsSection {
  std::vector<std::string> variants;  ///< by name
  std::vector<std::string> against;   ///< variants, by name
  std::vector<std::string> metrics;   ///< by name
  std::string at;                     ///< metric that makes a front with each of them
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
  std::optional<FrontsSection> fronts{};        ///< variants' fronts against those of others
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

/// Reads a sweep's `page`. Throws Error{bad_input} with file, line, reason and what would be right, also if a section
/// names a variant that is not among `variants`.
Page read_page(const YamlValue& value, const std::vector<std::string>& variants);

}  // namespace evbal
