#pragma once

#include "agents/protocol/messages.hpp"
#include "common/clock.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/planning/city_model.hpp"

#include <vector>

namespace evbal {

/// Slots that `flow` looks ahead from `minute` on: as many as the parameters say, fewer at the day's end, at least 1.
int slots_at(const DayClock& clock, int minute, const BalancingParameters& parameters);

/// Share of the cars whose passenger gets out in each region that do not come out low on battery, N.
Eigen::VectorXd share_fit(const PlanningData& data);

/// Cars that become vacant in the next `slots` slots if nobody is sent anywhere, of
///   - cars under way without passengers, by the minute in which they arrive,
///   - cars with passengers, likewise, without the share that comes out low on battery,
///   - cars that charge, by the city's session quantiles given how long each has been plugged in,
///   - cars that serve those who wait and those who appear: a share of these passengers (the same in all regions, at
///     most `flow_served`, and no more than there are cars for) gets out where `trips` says, after `flow_pickup` and
///     the minutes of the way, again without the share that comes out low.
/// Whether a car ends its session, or comes out low, is independent of the others; those that serve passengers to come
/// are a Poisson count. `data` are complete but for these; `reports`, by region, are those of `minute`.
FreedCars freed_cars(const PlanningData& data, const std::vector<Report>& reports, int minute, int slots,
                     const std::vector<double>& session_quantiles, const std::vector<TripShare>& trips,
                     const BalancingParameters& parameters);

}  // namespace evbal
