#pragma once

#include "common/yaml.hpp"
#include "common/yaml_writer.hpp"

#include <string>
#include <vector>

namespace evbal {

/// What a scenario expects of the totals of every run, or of every schedule of faults that a search finds; a run or a
/// search that fails it ends with exit status 1.
struct Expect {
  std::string metric;         ///< one of expectable_metrics()
  bool at_most = true;        ///< else at least
  double bound = 0.0;         ///< on the metric
  bool under_search = false;  ///< of the worst schedule that `evbal search` finds, and not of a run

  /// Whether a value keeps the bound.
  bool holds(double value) const { return at_most ? value <= bound : value >= bound; }

  /// "at most 900"
  std::string words() const;

  /// Field by field.
  bool operator==(const Expect&) const = default;
};

/// Names of the totals that may be expected, as summary.json has them.
const std::vector<std::string>& expectable_metrics();

/// Those that every run is held to: all but those under search.
std::vector<Expect> of_runs(const std::vector<Expect>& all);

/// Reads a list of `{metric: lost, at_most: 900}`. Throws Error{bad_input}.
std::vector<Expect> read_expect(const YamlValue& list);

/// Writes `{metric: lost, at_most: 900}`, which read_expect takes as an item.
void write_expect(YamlWriter& yaml, const Expect& expect);

}  // namespace evbal
