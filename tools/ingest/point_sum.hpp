#pragma once

#include "tools/records/raw_table.hpp"

#include <optional>
#include <string_view>

namespace evbal {

/// Adds up the numbers of points that a list tells of one station.
class PointSum {
 public:
  /// Adds a number, which is written as `text`; or says what is wrong with it.
  RowFault add(std::optional<double> number, std::string_view text);

  /// Puts the sum into `points`, or says why the station `name` has none.
  RowFault total(std::string_view name, int& points) const;

 private:
  bool told_ = false;
  double sum_ = 0.0;
};

}  // namespace evbal
