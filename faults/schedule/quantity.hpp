#pragma once

#include "common/random.hpp"
#include "common/yaml.hpp"

namespace evbal {

/// What a scalar of a schedule is written in.
enum class Unit {
  number,
  minutes,      ///< "90min"
  time_of_day,  ///< "17:30", as minutes after midnight
};

/// The values that a field may take, both ends in.
struct Range {
  double low = 0.0;   ///< least value
  double high = 0.0;  ///< greatest value
};

/// The distributions that a schedule knows, and `fixed`: a plain value.
enum class Law { fixed, uniform, normal, lognormal, exponential };

/// A scalar of a schedule: a value, or a distribution that it is drawn from.
struct Quantity {
  Law law = Law::fixed;  ///< how it is drawn
  double centre = 0.0;   ///< value, mean or median
  double spread = 0.0;   ///< standard deviation, or sigma of the logarithm
  Range range;           ///< a draw beyond it is set to the nearest end

  /// Whether it is still to be drawn.
  bool open() const { return law != Law::fixed; }

  /// Where all of its draws lie but the lowest and the highest 1 %; all of them if it is a value or uniform.
  Range likely() const;

  /// A value, within the range.
  double draw(RandomStream& stream) const;
};

/// Reads `90min` or `{lognormal: {median: 40min, sigma: 0.6}}`. Throws Error{bad_input} if a plain value, or a
/// distribution's mean, median or bound, lies outside of `range`.
Quantity read_quantity(const YamlValue& value, Unit unit, Range range);

}  // namespace evbal
