#pragma once

#include "common/yaml.hpp"
#include "common/yaml_writer.hpp"

#include <string>
#include <vector>

namespace evbal {

/// What a scenario expects of every run's totals; a run that fails it ends with exit status 1.
struct Expect {
  std::string metric;   ///< one of expectable_metrics()
  bool at_most = true;  ///< else at least
  double bound = 0.0;   ///< on the metric

  /// Whether a value keeps the bound.
  bool holds(double value) const { return at_most ? value <= bound : value >= bound; }

  /// "at most 900"
  std::string words() const;

  /// Field by field.
  bool operator==(const Expect&) const = default;
};

/// Names of the totals that may be expected, as summary.json has them.
const std::vector<std::string>& expectable_metrics();

/// Reads a list of `{metric: lost, at_most: 900}`. Throws Error{bad_input}.
std::vector<Expect> read_expect(const YamlValue& list);

/// Writes `{metric: lost, at_most: 900}`, which read_expect takes as an item.
void write_expect(YamlWriter& yaml, const Expect& expect);

}  // namespace evbal
