#pragma once

#include "common/eigen.hpp"
#include "experiments/bound/time_network.hpp"

#include <vector>

namespace evbal {

/// A column of the linear program on a network: +1 at `from`, -1 at `to`, +1 in the row of its passengers.
struct NetworkColumn {
  int from = -1;   ///< node, -1 if none
  int to = -1;     ///< node, -1 if none
  int group = -1;  ///< of passengers, -1 if none
};

/// The columns: ways, trips, then a column a group for those who are lost.
std::vector<NetworkColumn> columns_of(const TimeNetwork& network);

/// Values at the rows: cars at nodes, passengers of groups.
struct NetworkRows {
  Eigen::VectorXd nodes;   ///< by node
  Eigen::VectorXd groups;  ///< by group
};

/// The equations  A diag(weight) A' y = b  of an interior point, A being the columns of a network. Rows of groups are
/// eliminated by hand; what is left reaches no further than the longest trip, and LAPACK factors it as a band.
class NormalEquations {
 public:
  /// `network` must outlive this.
  explicit NormalEquations(const TimeNetwork& network);

  /// Takes weights, > 0, by column. False if they are too far apart to be factored.
  bool factor(const Eigen::VectorXd& weight);

  /// y for b, with the weights that were factored.
  NetworkRows solve(NetworkRows b) const;

 private:
  double& at(int a, int b) { return band_(std::abs(a - b), std::min(a, b)); }
  void add_ways(const Eigen::VectorXd& weight);
  void add_group(std::size_t group);
  void add_difference(const Way& one, const Way& other, double weight);

  const TimeNetwork& network_;
  Eigen::MatrixXd band_;          ///< (distance below the diagonal, column), as LAPACK has it
  Eigen::VectorXd trip_weight_;   ///< by trip
  Eigen::VectorXd group_weight_;  ///< by group: of all its columns
};

}  // namespace evbal
