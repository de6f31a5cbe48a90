#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/world/city.hpp"
#include "common/clock.hpp"
#include "coordinator/balancing/problem.hpp"
#include "coordinator/planning/city_model.hpp"

#include <vector>

namespace evbal {

/// Steps in a horizon that starts at `minute`: at most `tau`, fewer at the day's end, at least 1. The last one may
/// reach past the end.
int horizon_at(const DayClock& clock, int minute, int tau);

/// The fleet as the reports (by region, all of them) have it at `minute`. Occupied cars count at their destination,
/// those that arrive at once included; empty cars under way count in the window of `step` minutes in which they arrive
/// for the share of it that is left, with the rest in the next, and not at all after the horizon; drop-offs due count
/// wholly in the window in which they arrive.
FleetState fleet_state(const std::vector<Report>& reports, int minute, int step, int tau);

/// Working points of the reports, held over the horizon, N x tau.
Eigen::MatrixXd points_ahead(const std::vector<Report>& reports, int tau);

/// Charging points that are free by the end of each step if nobody plugs in: those free now, and those of plugged cars
/// that finish, each by the city's session quantiles given how long it has been plugged in. Variances are those of
/// independent finishes; horizon and thresholds are those of `completions`.
MomentSet free_points(const std::vector<Report>& reports, int minute, int step,
                      const std::vector<double>& session_quantiles, const MomentSet& completions);

}  // namespace evbal
