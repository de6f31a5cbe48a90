#include "tools/ingest/point_sum.hpp"

#include <cmath>

namespace evbal {
namespace {

constexpr double kMostPoints = 10'000.0;  // the reasons say so

}  // namespace

RowFault PointSum::add(std::optional<double> number, std::string_view text) {
  if (!number || std::abs(*number) > kMostPoints || *number != std::floor(*number)) {
    return {"no number of points, a whole number up to 10000", text};
  }
  sum_ += *number;
  told_ = true;
  return {};
}

RowFault PointSum::total(std::string_view name, int& points) const {
  if (!told_) {
    return {"no number of points told", name, false};
  }
  if (sum_ < 1.0 || sum_ > kMostPoints) {
    return {sum_ < 1.0 ? "no points" : "more than 10000 points", name, false};
  }
  points = static_cast<int>(sum_);
  return {};
}

}  // namespace evbal
