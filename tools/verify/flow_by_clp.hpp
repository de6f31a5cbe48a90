#pragma once

#include "experiments/bound/time_network.hpp"

namespace evbal {

/// The least price x lost + km over flows of cars in a network, by Clp's simplex method. Throws Error{run_failed} if
/// Clp finds none.
double flow_by_clp(const TimeNetwork& network, double price);

}  // namespace evbal
