#include "experiments/study/statistics/front.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace evbal {

std::optional<double> value_at(std::vector<FrontPoint> front, double cost) {
  std::sort(front.begin(), front.end(), [](const FrontPoint& a, const FrontPoint& b) {
    return std::pair(a.cost, a.value) < std::pair(b.cost, b.value);
  });
  const auto same_cost = [](const FrontPoint& a, const FrontPoint& b) { return a.cost == b.cost; };
  front.erase(std::unique(front.begin(), front.end(), same_cost), front.end());
  const auto above =
      std::find_if(front.begin(), front.end(), [cost](const FrontPoint& point) { return point.cost >= cost; });
  if (above == front.end() || (above == front.begin() && above->cost > cost)) {
    return std::nullopt;
  }
  if (above->cost == cost) {
    return above->value;
  }
  const auto below = std::prev(above);
  const double share = (cost - below->cost) / (above->cost - below->cost);
  return below->value + share * (above->value - below->value);
}

}  // namespace evbal
