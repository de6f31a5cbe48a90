#include "tools/fit/transition_counts.hpp"

#include "common/random.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace evbal {
namespace {

TEST(TransitionCounts, CountStatesAsTheProblemMeansThem) {
  TransitionCounts counts(2);
  const CarPlace vacant_here{CarState::vacant, 0};
  const CarPlace bound_there{CarState::occupied, 1};
  const CarPlace charging_there{CarState::plugged, 1};
  const CarPlace sent_there{CarState::rebalancing, 1};
  counts.add({vacant_here,
              vacant_here,
              vacant_here,
              vacant_here,
              bound_there,
              bound_there,
              bound_there,
              charging_there,
              sent_there,
              {CarState::low_battery, 0},
              {CarState::to_charger, 0}},
             {vacant_here, bound_there, charging_there, sent_there, vacant_here, bound_there, charging_there,
              vacant_here, vacant_here, vacant_here, vacant_here});
  Eigen::MatrixXd vacant = Eigen::MatrixXd::Zero(2, 6);
  vacant.row(0) << 1, 1, 0, 1, 0, 1;  // vacant here, there; occupied here, there; low-battery here, there
  Eigen::MatrixXd occupied = Eigen::MatrixXd::Zero(2, 4);
  occupied.row(1) << 1, 1, 0, 1;
  EXPECT_EQ(counts.vacant, vacant);
  EXPECT_EQ(counts.occupied, occupied);
}

TEST(TransitionsOf, ShrinkThinRowsTowardsTheDay) {
  TransitionCounts day(1);
  day.vacant << 0, 100, 0;
  TransitionCounts rare(1);
  rare.vacant << 0, 0, 1;
  TransitionCounts frequent(1);
  frequent.vacant << 0, 0, 10000;
  EXPECT_NEAR(transitions_of(rare, day, 10.0).vacant_to_occupied(0, 0), 10.0 / 11.0 * 100.0 / 110.0, 1e-6);
  EXPECT_GT(transitions_of(frequent, day, 10.0).vacant_to_low_battery(0, 0), 0.99);
}

TEST(TransitionsOf, CarsNeverSeenStay) {
  const TransitionCounts none(3);
  const Transitions stay = transitions_of(none, none, 50.0);
  EXPECT_TRUE(stay.vacant_to_vacant.isIdentity());
  EXPECT_TRUE(stay.occupied_to_vacant.isIdentity());
}

RC_GTEST_PROP(TransitionsOfProperty, RowsSumToOne, (std::uint64_t seed)) {
  RandomStream random(seed, Purpose::synthetic_city, {});
  const auto regions = 1 + static_cast<int>(random.below(6));
  TransitionCounts period(regions);
  const auto count = [&random] { return static_cast<double>(random.below(random.below(2) == 0 ? 1 : 1000)); };
  period.vacant = period.vacant.unaryExpr([&](double) { return count(); }).eval();
  period.occupied = period.occupied.unaryExpr([&](double) { return count(); }).eval();
  TransitionCounts day = period;
  day += period;
  const Transitions t = transitions_of(period, day, 50.0);
  const Eigen::MatrixXd p = t.vacant_to_vacant + t.vacant_to_occupied + t.vacant_to_low_battery;
  const Eigen::MatrixXd q = t.occupied_to_vacant + t.occupied_to_occupied;
  RC_ASSERT(((p.rowwise().sum().array() - 1.0).abs() < 1e-12).all());
  RC_ASSERT(((q.rowwise().sum().array() - 1.0).abs() < 1e-12).all());
  RC_ASSERT(t.vacant_to_vacant.minCoeff() >= 0.0 && t.vacant_to_occupied.minCoeff() >= 0.0);
}

}  // namespace
}  // namespace evbal
