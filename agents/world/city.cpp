#include "agents/world/city.hpp"

namespace evbal {

Eigen::VectorXi City::points() const {
  Eigen::VectorXi points = Eigen::VectorXi::Zero(size());
  for (const auto& station : stations) {
    points[station.region] += station.points;
  }
  return points;
}

std::vector<int> City::nearest_station() const {
  const Eigen::VectorXi points_of = points();
  std::vector<int> nearest(regions.size(), -1);
  for (int i = 0; i < size(); ++i) {
    for (int j = 0; j < size(); ++j) {
      int& best = nearest[i];
      if (points_of[j] > 0 && (best < 0 || j == i || (best != i && km(i, j) < km(i, best)))) {
        best = j;
      }
    }
  }
  return nearest;
}

}  // namespace evbal
