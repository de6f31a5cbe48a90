#include "coordinator/filter/evidence.hpp"

#include "coordinator/filter/count_law.hpp"

#include <algorithm>

namespace evbal {

void Evidence::add(const Excess& excess) {
  const double contradicted = excess.contradiction ? of_a_contradiction : 0.0;
  sum_ += surprise(excess.cars, excess.expected, excess.slack) + contradicted - usual;
  low_sum_ += surprise(excess.low, excess.expected_low, 0) - usual;
  const int foreseen = std::clamp(excess.cars, 0, excess.slack);
  cars_ += excess.cars - foreseen - excess.expected;
  low_ += excess.low - excess.expected_low;
  low_alone_ += excess.low - excess.expected_low;
  passengers_ += excess.passengers;
  variance_ += excess.variance;
  if (sum_ <= 0.0) {
    sum_ = cars_ = low_ = passengers_ = variance_ = 0.0;
  }
  if (low_sum_ <= 0.0) {
    low_sum_ = low_alone_ = 0.0;
  }
  if (sum_ <= 0.0 && low_sum_ <= 0.0) {
    clear();
  }
}

}  // namespace evbal
