#pragma once

#include "agents/world/city.hpp"
#include "common/eigen.hpp"
#include "coordinator/forecast/count_variance.hpp"
#include "coordinator/forecast/seasonal_fit.hpp"

#include <vector>

namespace evbal {

/// D, N x N: of the trips from j on these days, the share that goes to i and ends there within the step of `step`
/// minutes in which it starts, starts being even over the step.
Eigen::MatrixXd same_step_dropoffs(const City& city, const std::vector<DemandDay>& days, int step);

/// Probability integral transform of counts under negative binomials around their forecasts, for each lead in ten bins,
/// 10 x leads: 0.1 each if that distribution is right (Czado, Gneiting and Held 2009, which smooths out that counts are
/// whole).
Eigen::MatrixXd integral_transform(const std::vector<HeldOutDay>& days, const CountVariance& variance, int leads);

}  // namespace evbal
