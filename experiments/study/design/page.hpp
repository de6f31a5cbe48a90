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
  std::vector<std::string> variants;
  std::vector<std::string> against;
  std::vector<std::string> metrics;
  std::optional<std::string> at;
  std::map<std::string, double> aims;  ///< by metric, in per cent: reached if the difference is as low
};

/// Means over days, with intervals by t.
struct MeansSection {
  std::vector<std::string> variants;
  std::vector<std::string> metrics;
};

/// Spearman's rank correlation of metrics with another one, over all points of the variants on one day and seed.
struct CorrelateSection {
  std::vector<std::string> variants;
  std::vector<std::string> metrics;
  std::string with;
};

/// The settings of variants, as tuned.
struct SettingsSection {
  std::vector<std::string> variants;
};

struct PageSection {
  std::string title;
  std::string text;
  std::optional<CompareSection> compare{};
  std::optional<MeansSection> means{};
  std::optional<CorrelateSection> correlate{};
  std::optional<SettingsSection> settings{};
};

struct Page {
  std::string title;
  std::string text;
  Prices objective{};  ///< makes the metric `objective` of each day; empty: there is none
  std::vector<PageSection> sections;
};

/// Reads a sweep's `page`. Throws Error{bad_input} with file, line, reason and what would be right, also if a section
/// names a variant that is not among `variants`.
Page read_page(const YamlValue& value, const std::vector<std::string>& variants);

}  // namespace evbal
