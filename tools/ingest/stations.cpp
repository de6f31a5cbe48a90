#include "tools/ingest/stations.hpp"

#include "common/contract.hpp"

#include <algorithm>

namespace evbal {
namespace {

/// km from region i to a station in region j; none within the region.
double way(const Eigen::MatrixXd& km, Eigen::Index i, Eigen::Index j) {
  return i == j ? 0.0 : km(i, j);
}

std::vector<int> spread_out(const Eigen::MatrixXd& km, const Eigen::VectorXd& demand, int stations) {
  std::vector<int> chosen;
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(km.rows(), km.maxCoeff());
  while (static_cast<int>(chosen.size()) < stations) {
    int best = -1;
    double best_total = 0.0;
    for (int j = 0; j < km.cols(); ++j) {
      if (std::find(chosen.begin(), chosen.end(), j) != chosen.end()) {
        continue;
      }
      double total = 0.0;
      for (int i = 0; i < km.rows(); ++i) {
        total += demand[i] * std::min(nearest[i], way(km, i, j));
      }
      if (best < 0 || total < best_total) {
        best = j;
        best_total = total;
      }
    }
    for (int i = 0; i < km.rows(); ++i) {
      nearest[i] = std::min(nearest[i], way(km, i, best));
    }
    chosen.push_back(best);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace

std::vector<StationChoice> choose_stations(const Eigen::MatrixXd& km, const Eigen::VectorXd& demand, int stations,
                                           int points) {
  EVBAL_EXPECT(stations >= 1 && stations <= km.rows() && points >= stations,
               "from one station to one a region, each with a point");
  const std::vector<int> chosen = spread_out(km, demand, stations);
  std::vector<double> served(chosen.size(), 0.0);
  for (int i = 0; i < km.rows(); ++i) {
    const auto nearest =
        std::min_element(chosen.begin(), chosen.end(), [&](int a, int b) { return way(km, i, a) < way(km, i, b); });
    served[nearest - chosen.begin()] += demand[i];
  }
  std::vector<StationChoice> choices;
  choices.reserve(chosen.size());
  for (const int region : chosen) {
    choices.push_back({region, 1});
  }
  for (int left = points - stations; left > 0; --left) {
    // Highest averages: the next point goes where one point serves most.
    std::size_t neediest = 0;
    for (std::size_t s = 1; s < choices.size(); ++s) {
      if (served[s] * choices[neediest].points > served[neediest] * choices[s].points) {
        neediest = s;
      }
    }
    ++choices[neediest].points;
  }
  return choices;
}

}  // namespace evbal
