// GeoJSON as other programs write it.

#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tests/ingest/town.hpp"
#include "tools/ingest/ingest_partition.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace evbal {
namespace {

using namespace town;

ZoneFile read(const std::string& text, const ZoneFields& fields = {"LocationID", ""}) {
  const Folder folder;
  return read_zones(folder.write("zones.geojson", text), fields);
}

/// What is said of a file that is refused; nothing if it is taken.
std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    return error.what();
  }
  return "";
}

void expect_refused(const std::string& text, const std::string& reason) {
  EXPECT_NE(refusal(text).find(reason), std::string::npos) << "`" << refusal(text) << "` has not\n" << reason;
}

/// Zones as the file's sixteen, at the same places.
void expect_the_town(const ZoneFile& file) {
  const auto expected = read(collection(features())).zones;
  ASSERT_EQ(file.zones.size(), expected.size());
  for (std::size_t z = 0; z < expected.size(); ++z) {
    EXPECT_EQ(file.zones[z].name, expected[z].name);
    EXPECT_NEAR(file.zones[z].centre.lat, expected[z].centre.lat, 2e-6);
    EXPECT_NEAR(file.zones[z].centre.lon, expected[z].centre.lon, 2e-6);
  }
}

void expect_in_report(const ZoneFile& file, const std::string& line) {
  EXPECT_NE(file.report.find(line), std::string::npos) << file.report;
}

TEST(RawPolygons, MayHaveFeaturesWithoutAny) {
  const std::vector<std::pair<std::string, std::string>> kinds{
      {feature(named("264"), "null"), "dropped, no geometry: 1 (first: "},
      {R"({"type": "Feature", "properties": {"LocationID": 264}})", "dropped, no geometry: 1 (first: "},
      {feature("null", "null"), "dropped, no geometry: 1 (first: "},
      {feature(named("264"), polygon("[]")), "dropped, a polygon without coordinates: 1 (first: "},
      {feature(named("264"), polygon("[[]]")), "dropped, a polygon without coordinates: 1 (first: "},
      {feature(named("264"), R"({"type": "MultiPolygon", "coordinates": []})"),
       "dropped, a polygon without coordinates: 1 (first: "},
      {feature(named("264"), polygon("[[[9.7, 52.34], [9.7, 52.34], [9.7, 52.34]]]")),
       "dropped, a polygon smaller than 0.1 m: 1 (first: "},
      {feature(named("99"), R"({"type": "Point", "coordinates": [9.72, 52.35]})"),
       "dropped, geometry `Point`, which is no polygon: 1 (first: "}};
  for (const auto& [odd, line] : kinds) {
    auto all = features();
    all.insert(all.begin() + 7, odd);
    const ZoneFile file = read(collection(all));
    expect_the_town(file);
    expect_in_report(file, line);
    expect_in_report(file, "zones.geojson: feature 7)");
  }
}

TEST(RawPolygons, MayStandInACollection) {
  auto all = features();
  const std::string point = R"({"type": "Point", "coordinates": [9.72, 52.35]})";
  all[7] = feature(named("8"),
                   R"({"type": "GeometryCollection", "geometries": [)" + point + ", " + polygon(square(7)) + "]}");
  const ZoneFile file = read(collection(all));
  expect_the_town(file);
  expect_in_report(file, "geometry `Point`, which is no polygon: 1 (first: ");
  const auto in_collection = [](const std::string& geometry) {
    return R"({"type": "GeometryCollection", "geometries": [)" + geometry + "]}";
  };
  all[7] = feature(named("8"), in_collection(in_collection(polygon(square(7)))));
  expect_the_town(read(collection(all)));
  all.push_back(feature(named("17"), in_collection(point)));
  all.push_back(feature(named("18"), in_collection("")));
  const ZoneFile none = read(collection(all));
  expect_in_report(none, "geometry `Point`, which is no polygon: 1 (first: ");
  expect_in_report(none, "dropped, no geometry: 1 (first: ");
  EXPECT_EQ(none.report.find("without coordinates"), std::string::npos) << none.report;
}

TEST(RawPolygons, MayHaveHeightsAndAByteOrderMark) {
  expect_the_town(read(collection(features(
      [](double lon, double lat) { return "[" + std::to_string(lon) + "," + std::to_string(lat) + ", 57.5]"; }))));
  expect_the_town(read("\xEF\xBB\xBF" + collection(features())));
  expect_the_town(read(collection(features(), R"("name": "zones", "bbox": [1, 2, 3, 4], "crs": null, )")));
}

TEST(RawPolygons, AreNamedByTheirNumberWhereTheyLackAField) {
  const auto with = [](const std::string& properties) {
    auto all = features();
    all[7] = feature(properties, polygon(square(7)));
    return collection(all);
  };
  for (const std::string properties :
       {"null", "{}", R"({"LocationID": null})", R"({"LocationID": ""})", R"({"LocationID": "  "})", "[1]"}) {
    expect_refused(with(properties), "zones.geojson: feature 7: has no property `LocationID`");
  }
  expect_refused(with(R"({"LocationID": [8]})"), "feature 7: its name [8] is neither text nor a number");
  EXPECT_EQ(read(with("null"), {}).zones[7].name, "7") << "nothing is asked for";
}

TEST(RawPolygons, MayHaveAnIdOfTheirOwn) {
  std::string own = feature("{}", polygon(square(0)));
  own.insert(1, R"("id": 100000.0, )");
  EXPECT_EQ(read(collection({own}), {"id", ""}).zones[0].name, "100000");
}

TEST(RawPolygons, OfOneNameAreOneZone) {
  auto all = features();
  all[10] = feature(named("1"), polygon(square(10)));
  all[15] = feature(named("1.0"), polygon(square(15)));
  const ZoneFile file = read(collection(all));
  ASSERT_EQ(file.zones.size(), 14U);
  EXPECT_EQ(file.zones[0].rings.size(), 3U);
  EXPECT_NEAR(file.zones[0].area_m2 / file.zones[1].area_m2, 3.0, 1e-3);
  expect_in_report(file, "zones read: 14\n");
  expect_in_report(file, "polygons put to another of the same name: 2 (first: feature 10: `1`)");
}

TEST(RawPolygons, ThatAreGivenTwiceCountOnce) {
  auto all = features();
  all.push_back(feature(named("1"), polygon(square(0))));
  const ZoneFile file = read(collection(all));
  ASSERT_EQ(file.zones.size(), 16U);
  EXPECT_EQ(file.zones[0].rings.size(), 1U);
  EXPECT_NEAR(file.zones[0].area_m2 / file.zones[1].area_m2, 1.0, 1e-3);
}

TEST(RawPolygons, OfTextNamesStayApart) {
  auto all = features();
  all[0] = feature(named("\" 01 \""), polygon(square(0)));
  const ZoneFile file = read(collection(all));
  ASSERT_EQ(file.zones.size(), 16U);
  EXPECT_EQ(file.zones[0].name, "01");
}

TEST(RawPolygons, OfOneNameWeighTogether) {
  const auto weighing = [](double first, double second) {
    const auto part = [](int zone, double people) {
      return feature(R"({"LocationID": 1, "people": )" + std::to_string(people) + "}", polygon(square(zone)));
    };
    return read(collection({part(0, first), part(5, second)}), {"LocationID", "people"}).zones.front().weight;
  };
  EXPECT_EQ(weighing(30.0, 12.0), 42.0);
  EXPECT_EQ(weighing(30.0, 30.0), 30.0) << "copied when a zone was taken apart";
}

TEST(RawPolygons, WithAHoleWeighWithoutIt) {
  auto all = features();
  const std::string hole = "[[9.725,52.36],[9.725,52.365],[9.735,52.365],[9.735,52.36],[9.725,52.36]]";
  const std::string outer = square(5);
  all[5] = feature(named("6"), polygon(outer.substr(0, outer.size() - 1) + "," + hole + "]"));
  all.push_back(feature(named("88"), polygon("[" + hole + "]")));
  const ZoneFile file = read(collection(all));
  ASSERT_EQ(file.zones.size(), 17U);
  EXPECT_NEAR((file.zones[5].weight + file.zones[16].weight) / file.zones[4].weight, 1.0, 1e-3);
}

/// A position in Web Mercator metres.
std::string mercator(double lon, double lat) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  return in_degrees(6378137.0 * lon * kDegree,
                    6378137.0 * std::log(std::tan(std::numbers::pi / 4 + lat * kDegree / 2)));
}

TEST(RawPolygons, MayBeOfAnySystemThatTheyName) {
  for (const std::string name : {"urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4326", "urn:ogc:def:crs:EPSG::4258"}) {
    expect_the_town(read(collection(features(), crs(name))));
  }
  for (const std::string name :
       {"urn:ogc:def:crs:EPSG::3857", "EPSG:3857", "http://www.opengis.net/def/crs/EPSG/0/3857"}) {
    expect_the_town(read(collection(features(mercator), crs(name))));
  }
  std::vector<std::string> all = features(mercator);
  for (auto& each : all) {
    each.insert(1, crs("EPSG:3857"));
  }
  expect_the_town(read(collection(all)));
}

TEST(RawPolygons, AreRefusedOutsideTheSystemThatTheyName) {
  const auto kilometres = [](double lon, double lat) { return in_degrees(68.0 * (lon - 9.7), 111.0 * (lat - 52.34)); };
  expect_refused(collection(features(kilometres), crs("urn:ogc:def:crs:EPSG::25832")),
                 "feature 0: position 0, 0 lies where `ETRS89 / UTM zone 32N` is not used");
  expect_refused(collection(features(mercator)), "is not in degrees (WGS84); a member `crs` must name another system");
  expect_refused(collection(features(), crs("local")), "zones.geojson: its `crs` `local` is no coordinate reference");
  expect_refused(collection(features(), crs("EPSG:99999999")), "its `crs` `EPSG:99999999` is no coordinate reference");
  expect_refused(collection(features(), R"("crs": {"type": "link", "properties": {"href": "x"}}, )"),
                 "names no coordinate reference system");
  std::vector<std::string> all = features(mercator);
  all[3].insert(1, crs("local"));
  expect_refused(collection(all, crs("EPSG:3857")), "zones.geojson: feature 3: its `crs` `local`");
}

TEST(RawPolygons, ThatTouch180HangTogether) {
  const auto pacific = [](double lon, double lat) {
    const double east = lon - 9.74 + 180.0;
    return in_degrees(east > 180.0 + 1e-9 ? east - 360.0 : east, lat - 70.0);
  };
  const auto cut = [&](int zone) {  // what lies east of 180 has its western edge at -180
    std::string text = square(zone, pacific);
    if (zone % 4 == 2) {
      for (auto at = text.find("[180.0"); at != std::string::npos; at = text.find("[180.0")) {
        text.insert(at + 1, "-");
      }
    }
    return feature(named(std::to_string(zone + 1)), polygon(text));
  };
  std::vector<std::string> all;
  for (int zone = 0; zone < 16; ++zone) {
    all.push_back(cut(zone));
  }
  const Folder folder;
  const Partition made =
      partition_zones(read_bordering_zones(folder.write("zones.geojson", collection(all)), {"LocationID", ""}), 4);
  const auto neighbours = neighbours_of(made.zones);
  EXPECT_EQ(neighbours[1], (std::vector<int>{0, 2, 5}));
  EXPECT_EQ(neighbours[2], (std::vector<int>{1, 3, 6}));
  for (const Region& region : made.regions) {
    EXPECT_EQ(region.outline.size(), 1U) << region.name;
    EXPECT_NEAR(std::abs(region.centroid.lon), 179.98, 1e-4) << region.name;
    for (const LatLon point : region.outline.front()) {
      EXPECT_EQ(point.lon > 0.0, region.centroid.lon > 0.0) << "a region on one side of 180 is drawn there";
      EXPECT_LE(std::abs(point.lon), 180.0);
    }
  }
}

TEST(RawPolygons, MayCross180) {
  const ZoneFile file = read(collection({feature(
      named("1"), polygon("[[[179.99,-17.6],[-179.99,-17.6],[-179.99,-17.5],[179.99,-17.5],[179.99,-17.6]]]"))}));
  EXPECT_NEAR(file.zones[0].area_m2, 0.02 * 0.1 * 111195.0 * 111195.0 * std::cos(17.6 * std::numbers::pi / 180.0), 1e5);
  EXPECT_NEAR(std::abs(file.zones[0].centre.lon), 180.0, 1e-6);
}

TEST(RawPolygons, WhoseBorderCrossesItselfAreTold) {
  auto all = features();
  all[5] = feature(named("6"), polygon("[[[9.72,52.355],[9.74,52.37],[9.74,52.355],[9.72,52.37],[9.72,52.355]]]"));
  expect_in_report(read(collection(all)), "without area, since their border crosses itself: 1 (first: `6`)");
}

TEST(RawPolygons, AreRefusedWhereNestedTooDeep) {
  const int levels = 1'000'000;
  const std::string deep = std::string(levels, '[') + std::string(levels, ']');
  expect_refused(collection({feature(named(deep), polygon(square(0)))}), "nested more than a hundred levels deep");
  expect_refused(R"({"features": 1, "type": )" + deep + "}", "nested more than a hundred levels deep");
}

TEST(RawPolygons, AreRefusedWithWhatIsWrong) {
  const std::string whole = collection(features());
  expect_refused(whole.substr(0, 1500), ": is no GeoJSON: it breaks off; is the file truncated?");
  expect_refused(features()[0] + "\n" + features()[1] + "\n",
                 "zones.geojson:2: is no GeoJSON: something follows its end; put all into one FeatureCollection");
  expect_refused(features()[0], "is no GeoJSON FeatureCollection, but a `Feature`");
  expect_refused(R"({"type": "FeatureCollection", "features": null})",
                 "is no GeoJSON FeatureCollection, with a list of `features`");
  expect_refused(R"({"type": "Topology", "objects": {}})", "is no GeoJSON FeatureCollection, but a `Topology`");
  expect_refused("{\"type\": \"FeatureCollection\",\n \"features\": [}\n", "zones.geojson:2: is no GeoJSON: ");
  expect_refused(collection({features()[0], "7"}), "feature 1: is no GeoJSON Feature");
  expect_refused(collection({features()[0], feature(named("2"), "{}")}),
                 "feature 1: is no feature with a polygon: key 'type' not found");
  expect_refused(collection({features()[0], feature(named("2"), polygon("[[[1]]]"))}), "feature 1: is no feature with");
  expect_refused(collection({feature(named("2"), "null"), feature(named("2"), polygon("7"))}),
                 "dropped, no geometry: 1 (first: ");
}

}  // namespace
}  // namespace evbal
