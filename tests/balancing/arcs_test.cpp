#include "coordinator/balancing/arcs.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace evbal {
namespace {

// Regions on a line at 0, 1, 3, 20 km.
Eigen::MatrixXd line() {
  const Eigen::Vector4d at(0.0, 1.0, 3.0, 20.0);
  return (at.replicate(1, 4) - at.transpose().replicate(4, 1)).cwiseAbs();
}

std::string pairs(const std::vector<Arc>& arcs) {
  std::string text;
  for (const auto& arc : arcs) {
    text += std::to_string(arc.from) + std::to_string(arc.to) + ' ';
  }
  return text;
}

TEST(Arcs, NearRegionsAndTheFarOnesLifeline) {
  EXPECT_EQ(pairs(vacant_arcs(line(), 2.5, 12)), "01 10 12 21 23 32 ");
  EXPECT_EQ(pairs(vacant_arcs(line(), 0.0, 0)), "01 10 12 21 23 32 ");
  EXPECT_EQ(pairs(vacant_arcs(line(), 5.0, 1)), "01 10 12 21 23 32 ");
  EXPECT_EQ(pairs(vacant_arcs(line(), 5.0, 2)), "01 02 10 12 20 21 23 32 ");
}

TEST(Arcs, LowBatteryCarsGoToStationsOnly) {
  EXPECT_EQ(pairs(low_battery_arcs(line(), {true, false, false, true}, 2.5, 12)), "03 10 20 30 ");
  EXPECT_EQ(pairs(low_battery_arcs(line(), {false, false, false, false}, 2.5, 12)), "");
}

TEST(Arcs, NoRoadNoArc) {
  Eigen::MatrixXd km = line();
  km.row(3).setConstant(std::numeric_limits<double>::infinity());
  km.col(3).setConstant(std::numeric_limits<double>::infinity());
  EXPECT_EQ(pairs(vacant_arcs(km, 1e9, 12)), "01 02 10 12 20 21 ");
  EXPECT_EQ(pairs(vacant_arcs(Eigen::MatrixXd::Zero(1, 1), 10.0, 12)), "");
}

}  // namespace
}  // namespace evbal
