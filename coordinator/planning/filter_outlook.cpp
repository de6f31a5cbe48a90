#include "coordinator/planning/filter_outlook.hpp"

#include "coordinator/planning/charging_sessions.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

/// Of the minutes of a window of plans in which a trip may begin, the share of those from which it is over before the
/// window ends. It arrives in a later tick than it begins.
double share_over(int trip_minutes, int window, int tick) {
  int over = 0;
  for (int begins = 0; begins + trip_minutes < window; ++begins) {
    over += (begins / tick + 1) * tick < window ? 1 : 0;
  }
  return over > 0 ? static_cast<double>(over) / window : 0.0;
}

}  // namespace

FilterModel filter_model(const City& city, const DayClock& clock) {
  return {city.fleet.vehicles, city.points(), city.passengers.patience_low,
          city.minutes.array().ceil().max(static_cast<double>(clock.tick)),
          [quantiles = city.charging.session_quantiles](double so_far, double minutes) {
            return share_that_ends(quantiles, so_far, minutes);
          }};
}

std::vector<ShortTrips> short_trips(const std::vector<TripShare>& trips, const Eigen::MatrixXd& minutes, int window,
                                    int tick) {
  std::vector<ShortTrips> out;
  for (const TripShare& each : trips) {
    const int takes = std::max(1, static_cast<int>(std::ceil(minutes(each.origin, each.destination))));
    if (const double over = share_over(takes, window, tick); over > 0.0) {
      out.push_back({each.origin, each.destination, each.share * over});
    }
  }
  return out;
}

}  // namespace evbal
