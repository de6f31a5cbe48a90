#include "tools/ingest/zone_places.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// A square of 0.03 degrees with a hole of 0.01 in the middle.
std::vector<Zone> zones_with_holes() {
  const auto square = [](double south, double west, double side) {
    return std::vector<LatLon>{{south, west}, {south, west + side}, {south + side, west + side}, {south + side, west}};
  };
  std::vector<Zone> out(1);
  out[0].name = "a";
  add_ring(out[0], square(22.50, 114.00, 0.03), false);
  add_ring(out[0], square(22.51, 114.01, 0.01), true);
  measure(out[0]);
  return out;
}

TEST(ZonePlaces, AreSpreadEvenlyOverTheZone) {
  const std::vector<Zone> all = zones_with_holes();
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
  const std::vector<Zone> all = zones_with_holes();
  const ZonePlaces places(all);
  EXPECT_EQ(places.place("a", 5)->lat, places.place("a", 5)->lat);
  EXPECT_NE(places.place("a", 5)->lat, places.place("a", 6)->lat);
  EXPECT_FALSE(places.place("b", 5).has_value());
}

TEST(ZonePlaces, AreSpreadOverAllPolygonsOfAZone) {
  Zone zone;
  zone.name = "a";
  add_ring(zone, {{22.50, 114.00}, {22.50, 114.01}, {22.51, 114.01}, {22.51, 114.00}}, false);
  add_ring(zone, {{24.50, 116.00}, {24.50, 116.03}, {24.51, 116.03}, {24.51, 116.00}}, false);
  measure(zone);
  const std::vector<Zone> all{zone};
  const ZonePlaces places(all);
  int first = 0;
  const int draws = 4000;
  for (int draw = 0; draw < draws; ++draw) {
    const LatLon place = places.place("a", static_cast<std::uint64_t>(draw)).value();
    const bool in_first = place.lat <= 22.51 && place.lon <= 114.01;
    EXPECT_TRUE(in_first || (place.lat >= 24.50 && place.lon >= 116.00)) << place.lat << " " << place.lon;
    first += in_first ? 1 : 0;
  }
  EXPECT_NEAR(first, draws / 4, 120);
}

/// Whether the zones of these names have a place for what a table shows.
bool known(const std::vector<std::string>& names, const std::string& shown, char decimal = '.') {
  std::vector<Zone> all;
  for (const std::string& name : names) {
    all.push_back(zones_with_holes().front());
    all.back().name = name;
  }
  return ZonePlaces(all, decimal).place(shown, 1).has_value();
}

TEST(ZonePlaces, KnowANumberHoweverItIsWritten) {
  for (const std::string shown : {"132", "132.0", "0132", "00132.000", "132."}) {
    EXPECT_TRUE(known({"132"}, shown)) << shown;
    EXPECT_TRUE(known({"0132"}, shown)) << shown;
  }
  EXPECT_TRUE(known({"132"}, "132,0", ','));
  EXPECT_TRUE(known({"0"}, "0.0"));
  EXPECT_TRUE(known({"36061000100"}, "36061000100.0"));
  for (const std::string shown : {"132,0", "132.5", "1320", "-132", "+132", "1.32e2", "0x84", "", ".", ".0", "nan"}) {
    EXPECT_FALSE(known({"132"}, shown)) << shown;
  }
}

TEST(ZonePlaces, TakeTextAsText) {
  EXPECT_FALSE(known({"1e3"}, "1000"));
  EXPECT_FALSE(known({"01A"}, "1A"));
  EXPECT_FALSE(known({"132", "0132"}, "132.0")) << "either could be meant";
  EXPECT_TRUE(known({"132", "0132"}, "0132"));
}

}  // namespace
}  // namespace evbal
