// Shapefiles as other programs write them.

#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tools/ingest/zones.hpp"

#include <gtest/gtest.h>
#include <shapefil.h>

#include <algorithm>
#include <functional>
#include <numbers>
#include <tuple>

namespace evbal {
namespace {

namespace fs = std::filesystem;

const std::string kDegrees =
    R"(GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]],)"
    R"(PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]])";
/// New York's state plane in feet, as the city publishes its zones.
const std::string kStatePlane =
    R"(PROJCS["NAD_1983_StatePlane_New_York_Long_Island_FIPS_3104_Feet",GEOGCS["GCS_North_American_1983",)"
    R"(DATUM["D_North_American_1983",SPHEROID["GRS_1980",6378137.0,298.257222101]],PRIMEM["Greenwich",0.0],)"
    R"(UNIT["Degree",0.0174532925199433]],PROJECTION["Lambert_Conformal_Conic"],)"
    R"(PARAMETER["False_Easting",984250.0],PARAMETER["False_Northing",0.0],PARAMETER["Central_Meridian",-74.0],)"
    R"(PARAMETER["Standard_Parallel_1",40.66666666666666],PARAMETER["Standard_Parallel_2",41.03333333333333],)"
    R"(PARAMETER["Latitude_Of_Origin",40.16666666666666],UNIT["Foot_US",0.3048006096012192]])";

using Position = std::function<std::pair<double, double>(double east, double north)>;

/// Sixteen squares in four rows of four, named 1 to 16; `position` tells where a corner is, counted in squares. A
/// seventeenth shape is null.
fs::path write_squares(const Folder& folder, const std::string& prj, const Position& position) {
  const fs::path file = folder.path() / "zones.shp";
  SHPHandle shapes = SHPCreate(file.c_str(), SHPT_POLYGON);
  DBFHandle table = DBFCreate((folder.path() / "zones.dbf").c_str());
  DBFAddField(table, "LocationID", FTInteger, 4, 0);
  for (int zone = 0; zone < 17; ++zone) {
    double xs[5];
    double ys[5];
    const int corners[5][2]{{0, 0}, {0, 1}, {1, 1}, {1, 0}, {0, 0}};
    for (int c = 0; c < 5; ++c) {
      std::tie(xs[c], ys[c]) = position(zone % 4 + corners[c][0], static_cast<double>(zone / 4) + corners[c][1]);
    }
    SHPObject* shape = zone < 16 ? SHPCreateSimpleObject(SHPT_POLYGON, 5, xs, ys, nullptr)
                                 : SHPCreateSimpleObject(SHPT_NULL, 0, nullptr, nullptr, nullptr);
    SHPWriteObject(shapes, -1, shape);
    SHPDestroyObject(shape);
    DBFWriteIntegerAttribute(table, zone, 0, zone + 1);
  }
  SHPClose(shapes);
  DBFClose(table);
  if (!prj.empty()) {
    folder.write("zones.prj", prj);
  }
  return file;
}

std::pair<double, double> degrees_of(double east, double north) {
  return {9.70 + 0.02 * east, 52.34 + 0.015 * north};
}

std::pair<double, double> in_feet(double east, double north) {
  return {980'000.0 + 4400.0 * east, 190'000.0 + 5475.0 * north};
}

void expect_refused(const fs::path& file, const std::string& reason) {
  try {
    read_zones(file, {"LocationID", ""});
    FAIL() << "was accepted, expected: " << reason;
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
  }
}

TEST(RawShapefiles, MayHaveNullShapes) {
  const Folder folder;
  const ZoneFile file = read_zones(write_squares(folder, kDegrees, degrees_of), {"LocationID", ""});
  EXPECT_EQ(file.zones.size(), 16U);
  EXPECT_EQ(file.zones[15].name, "16");
  EXPECT_NE(file.report.find("dropped, a null shape or one without corners: 1 (first: "), std::string::npos)
      << file.report;
  EXPECT_NE(file.report.find("zones.shp: shape 16)"), std::string::npos) << file.report;
}

TEST(RawShapefiles, MayHaveShapesWithoutCorners) {
  const Folder folder;
  const fs::path file = write_squares(folder, kDegrees, degrees_of);
  SHPHandle shapes = SHPOpen(file.c_str(), "rb+");
  SHPObject* empty = SHPCreateObject(SHPT_POLYGON, 7, 0, nullptr, nullptr, 0, nullptr, nullptr, nullptr, nullptr);
  SHPWriteObject(shapes, 7, empty);
  SHPDestroyObject(empty);
  SHPClose(shapes);
  const ZoneFile read = read_zones(file, {"LocationID", ""});
  EXPECT_EQ(read.zones.size(), 15U);
  EXPECT_NE(read.report.find("dropped, a null shape or one without corners: 2 (first: "), std::string::npos)
      << read.report;
}

TEST(RawShapefiles, MayHaveEndingsInAnyCase) {
  for (const auto& [shp, shx, dbf, prj] : {std::tuple{".SHP", ".SHX", ".DBF", ".PRJ"},
                                           {".shp", ".shx", ".dbf", ".PRJ"},
                                           {".Shp", ".Shx", ".Dbf", ".Prj"}}) {
    const Folder folder;
    write_squares(folder, kStatePlane, in_feet);
    for (const auto& [from, to] : {std::pair{".shp", shp}, {".shx", shx}, {".dbf", dbf}, {".prj", prj}}) {
      fs::rename(folder.path() / ("zones" + std::string(from)), folder.path() / ("zones" + std::string(to)));
    }
    const ZoneFile file = read_zones(folder.path() / ("zones" + std::string(shp)), {"LocationID", ""});
    EXPECT_EQ(file.zones.size(), 16U) << shp;
    EXPECT_NEAR(file.zones[0].centre.lon, -74.0, 0.1) << "the .prj is read";
  }
}

TEST(RawShapefiles, MayBeOfAnyProjection) {
  const Folder folder;
  const ZoneFile file = read_zones(write_squares(folder, kStatePlane, in_feet), {"LocationID", ""});
  ASSERT_EQ(file.zones.size(), 16U);
  const auto& ring = file.zones[0].rings.front();
  const LatLon corner = point_of(*std::min_element(ring.begin(), ring.end()));
  EXPECT_NEAR(corner.lat, 40.688182, 1.1e-6) << "as PROJ's cs2cs has 980000, 190000 of EPSG:2263";
  EXPECT_NEAR(corner.lon, -74.015325, 1.1e-6);
  folder.write("zones.prj", "\xEF\xBB\xBF" + kStatePlane);
  EXPECT_EQ(read_zones(folder.path() / "zones.shp").zones[0].centre.lat, file.zones[0].centre.lat)
      << "a byte order mark";
  EXPECT_NEAR(file.zones[0].area_m2, 4400.0 * 5475.0 * 0.3048006 * 0.3048006, 1e4);
}

TEST(RawShapefiles, MayBeOfAnotherMeridian) {
  const std::string ferro =
      R"(GEOGCS["MGI_Ferro",DATUM["Militar_Geographische_Institut_Ferro",SPHEROID["Bessel 1841",6377397.155,299.1528128]],)"
      R"(PRIMEM["Ferro",-17.6666666666667],UNIT["degree",0.0174532925199433]])";
  const Folder folder;
  const fs::path file = write_squares(folder, ferro, [](double east, double north) {
    const auto [lon, lat] = degrees_of(east, north);
    return std::pair{lon + 17.6666666666667, lat};
  });
  const auto zones = read_zones(file, {"LocationID", ""}).zones;
  EXPECT_NEAR(zones[0].centre.lon, 9.71, 2e-3) << "but for the difference of the datums";
  EXPECT_NEAR(zones[0].centre.lat, 52.3475, 2e-3);
}

TEST(RawShapefiles, MayBeOfAnotherUnit) {
  const std::string radians =
      R"(GEOGCS["radians",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137,298.257223563]],PRIMEM["Greenwich",0],)"
      R"(UNIT["Radian",1]])";
  const Folder folder;
  const fs::path file = write_squares(folder, radians, [](double east, double north) {
    const auto [lon, lat] = degrees_of(east, north);
    return std::pair{lon * std::numbers::pi / 180.0, lat * std::numbers::pi / 180.0};
  });
  EXPECT_NEAR(read_zones(file).zones[0].centre.lon, 9.71, 1e-6);
}

TEST(RawShapefiles, OfGradsAreNeverTakenForDegrees) {
  const std::string paris =
      R"(GEOGCS["GCS_NTF_Paris",DATUM["D_NTF",SPHEROID["Clarke_1880_IGN",6378249.2,293.4660212936265]],)"
      R"(PRIMEM["Paris",2.337229166666667],UNIT["Grad",0.01570796326794897]])";
  const Folder folder;
  const fs::path file = write_squares(folder, paris, [](double east, double north) {
    const auto [lon, lat] = degrees_of(east, north);
    return std::pair{(lon - 2.337229166666667) / 0.9, lat / 0.9};
  });
  try {
    EXPECT_NEAR(read_zones(file).zones[0].centre.lon, 9.71, 2e-3) << "as newer versions of PROJ may";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("zones.prj:1: `NTF (Paris)` cannot be turned into WGS84 degrees"),
              std::string::npos)
        << error.what();
  }
}

TEST(RawShapefiles, AreRefusedOutsideTheirProjection) {
  const Folder folder;
  std::string without_parameters = kStatePlane;
  const auto begin = without_parameters.find("PARAMETER");
  without_parameters.erase(begin, without_parameters.find("UNIT[\"Foot") - begin);
  const fs::path file = write_squares(folder, without_parameters, in_feet);
  expect_refused(file, "New York Long Island");
  folder.write("zones.prj", kStatePlane);
  EXPECT_EQ(read_zones(file).zones.size(), 16U);
  fs::remove(folder.path() / "zones.prj");
  expect_refused(file,
                 "zones.shp: shape 0: position 980000, 190000 is not in degrees; a .prj beside the file must say");
  folder.write("zones.prj", "GEOGCRS[\"WGS 84\"");
  expect_refused(file, "zones.prj:1: `GEOGCRS[\"WGS 84\"` is no coordinate reference system that PROJ knows");
  folder.write("zones.prj", "WGS 84");
  expect_refused(file, "is no coordinate reference system that PROJ knows");
  write_squares(folder,
                R"(PROJCS["ETRS89 / UTM zone 32N",GEOGCS["ETRS89",DATUM["European_Terrestrial_Reference_System_1989",)"
                R"(SPHEROID["GRS 1980",6378137,298.257222101]],PRIMEM["Greenwich",0],)"
                R"(UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],)"
                R"(PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",9],)"
                R"(PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],)"
                R"(PARAMETER["false_northing",0],UNIT["metre",1]])",
                degrees_of);
  expect_refused(file, "lies where `ETRS89 / UTM zone 32N` is not used");
}

TEST(RawShapefiles, AreRefusedWithoutAName) {
  const Folder folder;
  const fs::path file = write_squares(folder, kDegrees, degrees_of);
  DBFHandle table = DBFOpen((folder.path() / "zones.dbf").c_str(), "rb+");
  DBFWriteNULLAttribute(table, 7, 0);
  DBFClose(table);
  expect_refused(file, "zones.dbf: record 7: has no `LocationID`");
}

}  // namespace
}  // namespace evbal
