#include "coordinator/filter/lie.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace evbal {
namespace {

// A number of cars as it rises and falls.
constexpr std::array truth{4, 5, 7, 8, 6, 5, 9, 11, 10, 7, 6, 4, 3, 5};
constexpr std::size_t before_it_lies = 5;

/// What kind a sensor is found to be that says `said(position in truth)`.
template <class Said>
SensorFaultKind found(const Said& said) {
  Lie lie({truth.begin(), truth.begin() + before_it_lies});
  for (std::size_t k = before_it_lies; k < truth.size(); ++k) {
    lie.hear(said(k), truth.at(k), 0.3);
  }
  return lie.kind();
}

TEST(Lie, IsNamedByWhatExplainsItBest) {
  EXPECT_EQ(found([](std::size_t /*k*/) { return truth.at(before_it_lies - 1); }), SensorFaultKind::stuck);
  EXPECT_EQ(found([](std::size_t k) { return truth.at(k) + 6; }), SensorFaultKind::biased);
  EXPECT_EQ(found([](std::size_t k) { return truth.at(k - 4); }), SensorFaultKind::delayed);
  EXPECT_EQ(found([](std::size_t k) {
              return truth.at(k) + std::array{5, -4, 2, -3, 6}.at(k % 5);
            }),
            SensorFaultKind::noisy);
  EXPECT_EQ(found([](std::size_t /*k*/) { return -1; }), SensorFaultKind::silent);
}

TEST(Lie, IsOverWhenTheTruthWasToldThreeTimes) {
  Lie lie({});
  lie.hear(9, 4.0, 0.5);
  lie.hear(5, 4.4, 0.5);
  lie.hear(6, 5.0, 0.5);
  EXPECT_FALSE(lie.over());
  lie.hear(12, 5.0, 0.5);
  for (const int said : {6, 5, 5}) {
    EXPECT_FALSE(lie.over());
    lie.hear(said, 5.2, 0.5);
  }
  EXPECT_TRUE(lie.over());
}

TEST(Lie, IsNotOverByOneWhereTheTruthIsKnown) {
  Lie lie({});
  for (int k = 0; k < 5; ++k) {
    lie.hear(3, 2.0, 0.0);
  }
  EXPECT_FALSE(lie.over());
}

}  // namespace
}  // namespace evbal
