#pragma once

#include "experiments/bound/starting_point.hpp"
#include "experiments/bound/time_network.hpp"

#include <functional>
#include <optional>

namespace evbal {

/// How well price x lost + km can be kept down in a network.
struct PricedFlow {
  double bound = 0.0;     ///< no way of driving comes below: holds at every moment of the solution
  double km = 0.0;        ///< without passengers, of the flow found last
  double lost = 0.0;      ///< passengers, of the flow found last
  bool solved = false;    ///< whether bound and flow agree within `flow_gap`
  int iterations = 0;     ///< of the interior point
  InnerPoint point = {};  ///< where it is
};

/// The largest relative difference of a flow's cost to its bound at which it is taken as solved.
inline constexpr double flow_gap = 1e-4;

/// Minimises price x lost + km over flows of cars by Mehrotra's predictor-corrector method, until solved, or `stop` is
/// true, which is asked before every iteration with what is known so far. Begins near `before`, if there is one: the
/// flow of the same network at a lower price.
PricedFlow priced_flow(const TimeNetwork& network, double price, const std::optional<PricedFlow>& before,
                       const std::function<bool(const PricedFlow&)>& stop);

}  // namespace evbal
