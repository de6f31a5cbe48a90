#include "tools/ingest/travel.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {

TravelLaw least_squares(double trips, double km, double minutes, double km2, double km_minutes) {
  const double spread = trips * km2 - km * km;
  TravelLaw law;
  law.per_km = spread > 0.0 ? (trips * km_minutes - km * minutes) / spread : 0.0;
  law.start = trips > 0.0 ? (minutes - law.per_km * km) / trips : 0.0;
  return law;
}

TravelSums::TravelSums(int regions, LatLon origin)
    : ends_(regions, origin), trips_(Eigen::MatrixXd::Zero(regions, regions)), km_(trips_), minutes_(trips_) {}

void TravelSums::add(int from, int to, const Trip& trip) {
  trips_(from, to) += 1.0;
  km_(from, to) += trip.km;
  minutes_(from, to) += trip.minutes;
  km2_ += trip.km * trip.km;
  km_minutes_ += trip.km * trip.minutes;
  ends_.add(from, trip.from, 1.0);
  ends_.add(to, trip.to, 1.0);
}

std::vector<LatLon> TravelSums::centroids(const std::vector<LatLon>& fallback) const {
  std::vector<LatLon> centroids = fallback;
  for (std::size_t i = 0; i < centroids.size(); ++i) {
    centroids[i] = ends_.mean(static_cast<int>(i)).value_or(centroids[i]);
  }
  return centroids;
}

TravelLaw TravelSums::law() const {
  return least_squares(trips_.sum(), km_.sum(), minutes_.sum(), km2_, km_minutes_);
}

TravelSums::Matrices TravelSums::matrices(const std::vector<LatLon>& centroids, double detour,
                                          double prior_trips) const {
  constexpr double kLeastKm = 0.1;
  constexpr double kLeastMinutes = 1.0;
  const auto n = static_cast<int>(trips_.rows());
  const TravelLaw by_km = law();
  Matrices all{trips_, trips_};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double between = distance(ends_.frame().local(centroids[i]), ends_.frame().local(centroids[j]));
      const double prior_km = detour * std::sqrt(between * between + ends_.spread2(i) + ends_.spread2(j)) / 1000.0;
      const double weight = trips_(i, j) + prior_trips;
      const double km = std::max(kLeastKm, (km_(i, j) + prior_trips * prior_km) / weight);
      const double prior_minutes = by_km.start + by_km.per_km * km;
      all.km(i, j) = km;
      all.minutes(i, j) = std::max(kLeastMinutes, (minutes_(i, j) + prior_trips * prior_minutes) / weight);
    }
  }
  return all;
}

}  // namespace evbal
