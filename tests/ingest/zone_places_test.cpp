#include "tools/ingest/zone_places.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// A square of 0.03 degrees with a hole of 0.01 in the middle, and a smaller one of the same name.
std::vector<Zone> zones() {
  const auto square = [](double south, double west, double side) {
    return std::vector<LatLon>{{south, west}, {south, west + side}, {south + side, west + side}, {south + side, west}};
  };
  std::vector<Zone> out(2);
  out[0].name = out[1].name = "a";
  add_ring(out[0], square(10.0, 10.0, 0.001), false);
  add_ring(out[1], square(22.50, 114.00, 0.03), false);
  add_ring(out[1], square(22.51, 114.01, 0.01), true);
  measure(out[0]);
  measure(out[1]);
  return out;
}

TEST(ZonePlaces, AreSpreadEvenlyOverTheZone) {
  const std::vector<Zone> all = zones();
  const ZonePlaces places(all);
  int east = 0;
  int middle = 0;
  const int draws = 4000;
  for (int draw = 0; draw < draws; ++draw) {
    const LatLon place = places.place("a", static_cast<std::uint64_t>(draw)).value();
    const bool in_box = place.lat >= 22.50 && place.lat <= 22.53 && place.lon >= 114.00 && place.lon <= 114.03;
    const bool in_hole = place.lat > 22.5101 && place.lat < 22.5199 && place.lon > 114.0101 && place.lon < 114.0199;
    EXPECT_TRUE(in_box && !in_hole) << place.lat << " " << place.lon;
    east += place.lon > 114.02 ? 1 : 0;
    middle += place.lon > 114.01 && place.lon <= 114.02 ? 1 : 0;
  }
  EXPECT_NEAR(east, draws * 3 / 8, 120);
  EXPECT_NEAR(middle, draws * 2 / 8, 120);
}

TEST(ZonePlaces, RepeatAndAreNowhereInAnUnknownZone) {
  const std::vector<Zone> all = zones();
  const ZonePlaces places(all);
  EXPECT_EQ(places.place("a", 5)->lat, places.place("a", 5)->lat);
  EXPECT_NE(places.place("a", 5)->lat, places.place("a", 6)->lat);
  EXPECT_FALSE(places.place("b", 5).has_value());
}

}  // namespace
}  // namespace evbal
