#pragma once

#include "experiments/bound/normal_equations.hpp"

namespace evbal {

/// A flow of cars and prices of nodes and passengers, with nothing at a bound.
struct InnerPoint {
  Eigen::VectorXd x;  ///< by column, > 0; cars and passengers are conserved
  NetworkRows y;      ///< prices; those of nodes are what a car is worth there, negative
  Eigen::VectorXd z;  ///< by column, > 0: what it costs beyond what y gives for it
};

/// Where an interior point begins. Values of cars fall from tick to tick, and at each node all ways are taken, the more
/// the less they cost.
InnerPoint starting_point(const TimeNetwork& network, const Eigen::VectorXd& cost);

/// A' y: what y gives for each column.
Eigen::VectorXd transposed(const std::vector<NetworkColumn>& columns, const NetworkRows& y);

}  // namespace evbal
