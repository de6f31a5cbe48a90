#pragma once

#include "agents/world/city.hpp"
#include "common/clock.hpp"
#include "common/eigen.hpp"
#include "coordinator/filter/fleet_filter.hpp"
#include "coordinator/planning/city_model.hpp"

#include <vector>

namespace evbal {

/// What the fleet's filter knows of the city.
FilterModel filter_model(const City& city, const DayClock& clock);

/// The trips, as shares of those of their origin, that begin in a window of so many minutes between two plans and are
/// over before its end. `minutes` are travel times, N x N; regions exchange cars every `tick` minutes.
std::vector<ShortTrips> short_trips(const std::vector<TripShare>& trips, const Eigen::MatrixXd& minutes, int window,
                                    int tick);

}  // namespace evbal
