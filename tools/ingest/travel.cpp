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
    : frame_(origin),
      trips_(Eigen::MatrixXd::Zero(regions, regions)),
      km_(trips_),
      minutes_(trips_),
      ends_(Eigen::VectorXd::Zero(regions)),
      east_(ends_),
      north_(ends_),
      square_(ends_) {}

void TravelSums::add(int from, int to, const Trip& trip) {
  trips_(from, to) += 1.0;
  km_(from, to) += trip.km;
  minutes_(from, to) += trip.minutes;
  km2_ += trip.km * trip.km;
  km_minutes_ += trip.km * trip.minutes;
  const auto add_end = [&](int region, LatLon point) {
    const LocalPoint at = frame_.local(point);
    ends_[region] += 1.0;
    east_[region] += at.east;
    north_[region] += at.north;
    square_[region] += at.east * at.east + at.north * at.north;
  };
  add_end(from, trip.from);
  add_end(to, trip.to);
}

std::vector<LatLon> TravelSums::centroids(const std::vector<LatLon>& fallback) const {
  std::vector<LatLon> centroids = fallback;
  for (int i = 0; i < ends_.size(); ++i) {
    if (ends_[i] > 0.0) {
      centroids[i] = frame_.global({east_[i] / ends_[i], north_[i] / ends_[i]});
    }
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
  const auto n = static_cast<int>(ends_.size());
  const TravelLaw by_km = law();
  Matrices all{trips_, trips_};
  const auto spread2 = [&](int i) {  // s^2, m^2
    if (ends_[i] == 0.0) {
      return 0.0;
    }
    const double east = east_[i] / ends_[i];
    const double north = north_[i] / ends_[i];
    return std::max(0.0, square_[i] / ends_[i] - east * east - north * north);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double between = distance(frame_.local(centroids[i]), frame_.local(centroids[j]));
      const double prior_km = detour * std::sqrt(between * between + spread2(i) + spread2(j)) / 1000.0;
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
