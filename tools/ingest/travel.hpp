#pragma once

#include "agents/world/geometry.hpp"
#include "common/eigen.hpp"
#include "tools/ingest/trip_end_sums.hpp"
#include "tools/ingest/trips.hpp"

#include <vector>

namespace evbal {

/// minutes = start + per_km * km.
struct TravelLaw {
  double start = 0.0;   ///< minutes
  double per_km = 0.0;  ///< minutes
};

/// The law that fits trips best, from their number and their sums of km, minutes, km * km and km * minutes.
TravelLaw least_squares(double trips, double km, double minutes, double km2, double km_minutes);

/// Sums over trips from which km and minutes of every pair of regions follow, seen or not.
class TravelSums {
 public:
  /// No trips yet. Places are measured in metres around `origin`.
  TravelSums(int regions, LatLon origin);

  /// Counts a trip from one region to another.
  void add(int from, int to, const Trip& trip);

  /// Mean of the trip ends in each region; `fallback` where there is none.
  std::vector<LatLon> centroids(const std::vector<LatLon>& fallback) const;

  /// Least squares over all trips.
  TravelLaw law() const;

  /// Means of every pair of regions, N x N, from row to column.
  struct Matrices {
    Eigen::MatrixXd km;       ///< driven distance
    Eigen::MatrixXd minutes;  ///< driving time
  };

  /// Means per pair, shrunk: a pair's km towards detour * sqrt(D^2 + s_from^2 + s_to^2), the root mean square distance
  /// of two independent trip ends (D between the centroids, s the spread around each); its minutes towards the
  /// law at its km. The prior weighs as much as `prior_trips` trips.
  Matrices matrices(const std::vector<LatLon>& centroids, double detour, double prior_trips) const;

 private:
  TripEndSums ends_;
  Eigen::MatrixXd trips_;
  Eigen::MatrixXd km_;  // sums
  Eigen::MatrixXd minutes_;
  double km2_ = 0.0;  // sums over all trips
  double km_minutes_ = 0.0;
};

}  // namespace evbal
