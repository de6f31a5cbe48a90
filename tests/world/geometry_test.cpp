#include "agents/world/geometry.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace evbal {
namespace {

constexpr LatLon kSanFrancisco{37.7749, -122.4194};

TEST(LocalFrame, MeasuresADegree) {
  // Length of a degree at the latitude, WGS84 series (National Geospatial-Intelligence Agency): 110.995 km north,
  // 88.104 km east.
  const LocalFrame frame(kSanFrancisco);
  EXPECT_NEAR(frame.local({kSanFrancisco.lat + 0.01, kSanFrancisco.lon}).north, 1109.95, 0.05);
  EXPECT_NEAR(frame.local({kSanFrancisco.lat, kSanFrancisco.lon + 0.01}).east, 881.04, 0.05);
}

RC_GTEST_PROP(LocalFrame, GoesThereAndBack, ()) {
  const LocalPoint place{*rc::gen::inRange(-60'000, 60'000) / 1.0, *rc::gen::inRange(-60'000, 60'000) / 1.0};
  const LocalFrame frame(kSanFrancisco);
  RC_ASSERT(distance(frame.local(frame.global(place)), place) < 1e-6);
}

TEST(OutlineMap, FindsTheOutlineOrTheNearest) {
  const LocalFrame frame(kSanFrancisco);
  const auto square = [&](double east, double north) {
    return Outline{{frame.global({east, north}), frame.global({east + 1000, north}),
                    frame.global({east + 1000, north + 1000}), frame.global({east, north + 1000})}};
  };
  const std::vector<Outline> outlines{square(0, 0), square(2000, 0)};
  const OutlineMap map(outlines);
  EXPECT_EQ(map.containing(frame.global({500, 500})), 0);
  EXPECT_EQ(map.containing(frame.global({2500, 500})), 1);
  EXPECT_EQ(map.containing(frame.global({1600, 500})), std::nullopt);
  EXPECT_EQ(map.nearest(frame.global({1600, 500})).outline, 1);
  EXPECT_NEAR(map.nearest(frame.global({1600, 500})).metres, 400.0, 0.1);
  EXPECT_EQ(map.nearest(frame.global({500, 500})).metres, 0.0);
}

}  // namespace
}  // namespace evbal
