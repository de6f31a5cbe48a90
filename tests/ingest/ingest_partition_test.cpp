#include "tools/ingest/ingest_partition.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>
#include <shapefil.h>

#include <cmath>
#include <set>

namespace evbal {
namespace {

/// Squares of 0.01 degrees in a row from (22.5, 114.0) on, named by letters, the first as heavy as all others; the last
/// lies 0.1 degrees further out.
constexpr int kSquares = 7;

double west_of(int square) {
  return 114.0 + 0.01 * square + (square == kSquares - 1 ? 0.1 : 0.0);
}

std::string geojson(double jitter) {
  std::string out = R"({"type": "FeatureCollection", "features": [)";
  for (int i = 0; i < kSquares; ++i) {
    const std::string west = std::to_string(west_of(i) + (i % 2 == 0 ? jitter : 0.0));
    const std::string east = std::to_string(west_of(i) + 0.01 - (i % 2 == 0 ? jitter : 0.0));
    out += std::string(i > 0 ? "," : "") + R"({"type":"Feature","properties":{"id":")" + char('a' + i) +
           R"(","jobs":)" + (i == 0 ? "6" : "1") + R"(},"geometry":{"type":"Polygon","coordinates":[[[)" + west +
           ",22.5],[" + east + ",22.5],[" + east + ",22.51],[" + west + ",22.51],[" + west + ",22.5]]]}}";
  }
  return out + "]}";
}

const std::string kWebMercator =
    R"(PROJCS["WGS_1984_Web_Mercator_Auxiliary_Sphere",GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",)"
    R"(SPHEROID["WGS_1984",6378137.0,298.257223563]],PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]],)"
    R"(PROJECTION["Mercator_Auxiliary_Sphere"],PARAMETER["False_Easting",0.0],PARAMETER["False_Northing",0.0],)"
    R"(PARAMETER["Central_Meridian",0.0],PARAMETER["Standard_Parallel_1",0.0],PARAMETER["Auxiliary_Sphere_Type",0.0],)"
    R"(UNIT["Meter",1.0]])";

/// The same squares as a shapefile of Web Mercator metres.
std::filesystem::path write_shapefile(const Folder& folder) {
  const double pi = std::acos(-1.0);
  const auto x = [&](double lon) { return 6378137.0 * lon * pi / 180.0; };
  const auto y = [&](double lat) { return 6378137.0 * std::log(std::tan(pi / 4.0 + lat * pi / 360.0)); };
  const std::string file = (folder.path() / "zones.shp").string();
  SHPHandle shapes = SHPCreate(file.c_str(), SHPT_POLYGON);
  DBFHandle table = DBFCreate((folder.path() / "zones.dbf").c_str());
  DBFAddField(table, "id", FTString, 4, 0);
  DBFAddField(table, "jobs", FTDouble, 10, 2);
  DBFAddField(table, "zone", FTDouble, 20, 11);
  for (int i = 0; i < kSquares; ++i) {
    const double west = x(west_of(i));
    const double east = x(west_of(i) + 0.01);
    double xs[5]{west, west, east, east, west};  // clockwise
    double ys[5]{y(22.5), y(22.51), y(22.51), y(22.5), y(22.5)};
    SHPObject* square = SHPCreateSimpleObject(SHPT_POLYGON, 5, xs, ys, nullptr);
    SHPWriteObject(shapes, -1, square);
    SHPDestroyObject(square);
    DBFWriteStringAttribute(table, i, 0, std::string(1, char('a' + i)).c_str());
    DBFWriteDoubleAttribute(table, i, 1, i == 0 ? 6.0 : 1.0);
    DBFWriteDoubleAttribute(table, i, 2, 100.0 + i);
  }
  SHPClose(shapes);
  DBFClose(table);
  folder.write("zones.prj", kWebMercator);
  return file;
}

void expect_refused(const std::filesystem::path& file, const ZoneFields& fields, const std::string& reason) {
  try {
    read_zones(file, fields);
    FAIL() << "was accepted, expected: " << reason;
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    EXPECT_TRUE(std::string(error.what()).starts_with(file.parent_path().string())) << error.what();
    EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
  }
}

TEST(IngestPartition, BalancesTheChosenField) {
  const Folder folder;
  const Partition made =
      partition_zones(read_bordering_zones(folder.write("zones.geojson", geojson(0.0)), {"id", "jobs"}), 2);
  EXPECT_EQ(made.region_of[1], made.region_of[6]) << "the one far out belongs to the nearest";
  EXPECT_NE(made.region_of[0], made.region_of[1]) << "the heavy one weighs as much as all others";
  EXPECT_EQ(zones_csv(made).substr(0, 18), "zone,region\na," + made.regions[made.region_of[0]].name + "\n");
  const auto zones = read_zones(folder.path() / "zones.geojson").zones;
  EXPECT_EQ(zones[0].weight, zones[0].area_m2) << "without a field they weigh by area";
}

TEST(IngestPartition, MakesOneRegionOfEachZone) {
  const Folder folder;
  const Partition made =
      partition_zones(read_bordering_zones(folder.write("zones.geojson", geojson(0.0)), {}), kSquares);
  EXPECT_EQ(std::set<int>(made.region_of.begin(), made.region_of.end()).size(), kSquares);
  EXPECT_THROW(partition_zones({made.zones, {}}, kSquares + 1), Error);
}

TEST(IngestPartition, SharesBordersThatNearlyTouch) {
  const Folder folder;
  constexpr double kFiveMetres = 5e-5;
  const auto file = folder.write("zones.geojson", geojson(kFiveMetres));
  EXPECT_TRUE(neighbours_of(read_zones(file).zones)[1].empty());
  const Partition made = partition_zones(read_bordering_zones(file, {}), 1);
  EXPECT_EQ(neighbours_of(made.zones)[1], (std::vector<int>{0, 2}));
  EXPECT_EQ(made.regions[0].outline.size(), 2U) << "all in a row, and the one far out";
}

TEST(ReadZones, OfAShapefileAreThoseOfTheGeojson) {
  const Folder folder;
  const auto zones = read_zones(write_shapefile(folder), {"id", "jobs"}).zones;
  const auto expected = read_zones(folder.write("zones.geojson", geojson(0.0)), {"id", "jobs"}).zones;
  ASSERT_EQ(zones.size(), expected.size());
  for (std::size_t z = 0; z < zones.size(); ++z) {
    EXPECT_NEAR(zones[z].centre.lat, expected[z].centre.lat, 1e-6);
    EXPECT_NEAR(zones[z].centre.lon, expected[z].centre.lon, 1e-6);
    EXPECT_NEAR(zones[z].area_m2 / expected[z].area_m2, 1.0, 1e-3);
    EXPECT_EQ(zones[z].name, expected[z].name);
    EXPECT_EQ(zones[z].weight, expected[z].weight);
  }
  EXPECT_EQ(read_zones(folder.path() / "zones.shp", {"zone", ""}).zones[1].name, "101");
}

TEST(ReadZones, RefusesWhatIsNoShapefile) {
  const Folder folder;
  const auto file = write_shapefile(folder);
  const std::string whole = text_of(file);
  expect_refused(file, {"", "people"}, "has no field `people`");
  expect_refused(file, {"", "id"}, "weight `a` is no number");
  folder.write("zones.shp", whole.substr(0, whole.size() - 60));
  expect_refused(file, {}, "truncated");
  folder.write("zones.shp", "nothing of the kind");
  expect_refused(file, {}, "cannot be read as a shapefile");
  folder.write("zones.shp", whole);
  folder.write("zones.prj", "PROJCS[\"OSGB 1936 / British National Grid\"]");
  expect_refused(file, {}, "zones.prj:1: `PROJCS[");
  std::filesystem::remove(folder.path() / "zones.prj");
  expect_refused(file, {}, "is not in degrees");
}

TEST(ReadZones, RefusesWhatIsNoGeojson) {
  const Folder folder;
  const auto refused = [&](const std::string& text, const ZoneFields& fields, const std::string& reason) {
    expect_refused(folder.write("zones.geojson", text), fields, reason);
  };
  refused("", {}, "is no GeoJSON");
  refused("[]", {}, "is no GeoJSON");
  refused(R"({"features": []})", {}, "has no polygon");
  refused(R"({"features": {"a": 1}})", {}, "is no GeoJSON FeatureCollection");
  refused(R"({"features": [{"geometry": {"type": "Point"}}]})", {},
          "has no polygon\n  dropped, geometry `Point`, which is no polygon: 1 (first: ");
  refused(geojson(0.0), {"name", ""}, "feature 0: has no property `name`");
  refused(geojson(0.0), {"", "id"}, "weight \"a\" is no number");
  refused(R"({"features": [{"geometry": {"type": "Polygon", "coordinates": [[[500, 2], [3, 4], [5, 6]]]}}]})", {},
          "feature 0: position 500, 2 is not in degrees");
}

}  // namespace
}  // namespace evbal
