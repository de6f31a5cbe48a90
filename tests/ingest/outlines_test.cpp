#include "tools/ingest/outlines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace evbal {
namespace {

constexpr Corner kCorner{37'750'000, -122'450'000};

/// A rectangle in thousandths of a degree from the origin.
Zone rectangle(int west, int south, int east, int north) {
  const auto corner = [](int x, int y) { return Corner{kCorner.lat + 1000 * y, kCorner.lon + 1000 * x}; };
  Zone zone;
  zone.rings = {{corner(west, south), corner(east, south), corner(east, north), corner(west, north)}};
  zone.centre = point_of(corner((west + east) / 2, (south + north) / 2));
  zone.area_m2 = 1.0;
  return zone;
}

/// Square degrees.
double area_of(const Outline& outline) {
  double twice = 0.0;
  for (const auto& ring : outline) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const LatLon& a = ring[i];
      const LatLon& b = ring[(i + 1) % ring.size()];
      twice += a.lon * b.lat - b.lon * a.lat;
    }
  }
  return twice / 2.0;
}

TEST(Neighbours, ShareAnEdgeNotJustACorner) {
  const std::vector<Zone> zones{rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1), rectangle(1, 1, 2, 2)};
  EXPECT_EQ(neighbours_of(zones), (std::vector<std::vector<int>>{{1}, {0, 2}, {1}}));
}

TEST(MergedOutlines, DissolveInnerEdges) {
  const std::vector<Zone> zones{rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1), rectangle(0, 1, 1, 2),
                                rectangle(1, 1, 2, 2)};
  const auto outlines = merged_outlines(zones, std::vector<int>{0, 0, 0, 0}, 1, 1.0);
  ASSERT_EQ(outlines.size(), 1U);
  ASSERT_EQ(outlines[0].size(), 1U);
  EXPECT_EQ(outlines[0][0].size(), 4U);
  EXPECT_NEAR(area_of(outlines[0]), 4e-6, 1e-12);
}

TEST(MergedOutlines, LeaveOutHolesAndZonesOfNoRegion) {
  std::vector<Zone> zones;
  std::vector<int> region_of;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      zones.push_back(rectangle(x, y, x + 1, y + 1));
      region_of.push_back(x == 1 && y == 1 ? -1 : 0);
    }
  }
  const auto outlines = merged_outlines(zones, region_of, 1, 1.0);
  ASSERT_EQ(outlines[0].size(), 1U);
  EXPECT_NEAR(area_of(outlines[0]), 9e-6, 1e-12);
}

TEST(MergedOutlines, KeepCommonBordersCommon) {
  // A border that zigzags by 0.05 thousandths of a degree (5 m): both sides simplify it to the same line.
  Zone west = rectangle(0, 0, 10, 10);
  Zone east = rectangle(10, 0, 20, 10);
  std::vector<Corner> border;
  for (int y = 1; y < 10; ++y) {
    border.push_back({kCorner.lat + 1000 * y, kCorner.lon + 10'000 + (y % 2 == 0 ? 50 : -50)});
  }
  auto& west_ring = west.rings[0];
  west_ring.insert(west_ring.begin() + 2, border.begin(), border.end());
  auto& east_ring = east.rings[0];
  east_ring.insert(east_ring.end(), border.rbegin(), border.rend());
  const auto fine = merged_outlines({west, east}, std::vector<int>{0, 1}, 2, 0.5);
  const auto coarse = merged_outlines({west, east}, std::vector<int>{0, 1}, 2, 20.0);
  EXPECT_EQ(fine[0][0].size(), 4U + border.size());
  EXPECT_EQ(coarse[0][0].size(), 4U);
  EXPECT_EQ(coarse[1][0].size(), 4U);
  EXPECT_NEAR(area_of(coarse[0]) + area_of(coarse[1]), 200e-6, 1e-12);
}

TEST(MergedOutlines, BearZonesThatOverlap) {
  // The second zone lies within the first and shares two of its edges.
  const std::vector<Zone> zones{rectangle(0, 0, 2, 1), rectangle(0, 0, 1, 1), rectangle(2, 0, 3, 1)};
  const auto apart = merged_outlines(zones, std::vector<int>{0, 1, 0}, 2, 1.0);
  EXPECT_NEAR(area_of(apart[0]), 3e-6, 1e-12);
  EXPECT_NEAR(area_of(apart[1]), 1e-6, 1e-12);
}

TEST(MergedOutlines, DropSlivers) {
  const std::vector<Zone> zones{rectangle(0, 0, 100, 100), rectangle(200, 0, 205, 5)};
  const auto outlines = merged_outlines(zones, std::vector<int>{0, 0}, 1, 1.0);
  EXPECT_EQ(outlines[0].size(), 1U);
}

}  // namespace
}  // namespace evbal
