// Lists of stations as Open Charge Map exports them.

#include "agents/world/geometry.hpp"
#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tests/packed.hpp"
#include "tools/ingest/ingest_stations.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// An entry at a place of the town; `points` are members.
std::string entry(const std::string& title, const std::string& place, const std::string& points) {
  return R"({"ID": 1, "UUID": "x", "AddressInfo": {"ID": 2, "Title": )" + title + R"(, "Town": null, )" + place +
         R"(}, "OperatorID": null, )" + points + "}";
}

const std::string kPlace = R"("Latitude": 52.3475, "Longitude": 9.71)";
const std::string kOtherPlace = R"("Latitude": 52.3625, "Longitude": 9.73)";

class OpenChargeMap : public testing::Test {
 protected:
  /// "name points" of each station.
  std::vector<std::string> ingest(const std::string& json, const std::string& name = "poi.json") {
    const std::vector<Region> all{
        {"all", {{{52.34, 9.70}, {52.34, 9.78}, {52.40, 9.78}, {52.40, 9.70}}}, {52.37, 9.74}}};
    YamlMap map(YamlValue::parse("layout: open-charge-map\n", "format.yaml"));
    const StationFormat format = read_station_format(map);
    map.finish();
    const auto made = ingest_stations(folder_.write(name, json), format, all, 500.0);
    report_ = made.report;
    std::vector<std::string> stations;
    for (const Station& station : made.stations) {
      stations.push_back(station.name + " " + std::to_string(station.points));
    }
    return stations;
  }

  void expect_reported(const std::string& line) const {
    EXPECT_NE(report_.find(line), std::string::npos) << line << " not in\n" << report_;
  }

  void expect_refused(const std::string& json, const std::string& reason) {
    try {
      ingest(json);
      FAIL() << "was accepted, expected: " << reason;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }

  std::string at(int position) const {
    return (folder_.path() / "poi.json").string() + ": entry " + std::to_string(position);
  }

  Folder folder_;
  std::string report_;
};

using Stations = std::vector<std::string>;

TEST_F(OpenChargeMap, TellsPointsOrConnections) {
  EXPECT_EQ(ingest("\xEF\xBB\xBF[" +
                   entry("\"Town hall\"", kPlace,
                         R"("NumberOfPoints": 2, "Connections": [{"Quantity": 2},)"
                         R"( {"Quantity": 2}])") +
                   ",\n" +
                   entry("\"Market\\nplace\"", kOtherPlace,
                         R"("NumberOfPoints": null, "Connections":)"
                         R"( [{"PowerKW": 22, "Quantity": 3.0}, {"Quantity": 1}])") +
                   "]\n"),
            (Stations{"Town hall 2", "Market place 4"}));
  EXPECT_EQ(ingest("[" + entry("\"a\"", kPlace, R"("NumberOfPoints": 0, "Connections": [{"Quantity": 1}])") + "]"),
            Stations{"a 1"})
      << "0 stands for not told";
  EXPECT_EQ(ingest(packed("[" + entry("\"a\"", kPlace, R"("NumberOfPoints": 2)") + "]", "gzip"), "poi.json.gz"),
            Stations{"a 2"});
}

TEST_F(OpenChargeMap, OfOneNameAddUpNearAndAreSeveralFarApart) {
  const std::string one = R"("NumberOfPoints": 1)";
  EXPECT_EQ(ingest("[" + entry("\"Shop\"", kPlace, one) + "," + entry("\"Shop\"", kPlace, one) + "," +
                   entry("\"Shop\"", kOtherPlace, one) + "]"),
            (Stations{"Shop 2", "Shop 2 1"}));
  expect_reported("further rows of a station, points added up: 1 (first: " + at(1) + ": `Shop`)");
  expect_reported("of a name that another station has, numbered: 1 (first: " + at(2));
}

TEST_F(OpenChargeMap, CountsWhatIsNull) {
  const std::string two = R"("NumberOfPoints": 2)";
  EXPECT_EQ(ingest("[" + entry("\"ok\"", kPlace, two) + "," + entry("\"untold\"", kPlace, R"("Connections": null)") +
                   "," + entry("\"empty\"", kPlace, R"("Connections": [{"Quantity": null}, {}])") + "," +
                   entry("\"half\"", kOtherPlace, R"("Connections": [{"Quantity": 4}, {"Quantity": null}])") + "," +
                   entry("null", kPlace, two) + "," + entry("\"no place\"", R"("Latitude": null)", two) + "," +
                   entry("\"west\"", R"("Latitude": 52.35, "Longitude": 960)", two) + "," +
                   entry("\"odd\"", kPlace, R"("NumberOfPoints": "many")") + "," +
                   entry("\"minus\"", kPlace, R"("Connections": [{"Quantity": 0}])") + "," +
                   entry("\"swapped\"", R"("Latitude": 9.71, "Longitude": 52.3475)", two) + R"(, {"ID": 3}, 7])"),
            (Stations{"ok 2", "half 4"}));
  expect_reported("rows read: 12\n");
  for (const std::string& line :
       {"dropped, no number of points told: 2 (first: " + at(1) + ": `untold`)",
        "dropped, a connection without a number, beside others: 1 (first: " + at(3) + ": `half`)",
        "dropped, no name: 1 (first: " + at(4) + ": `52.3475, 9.71`)",
        "dropped, no latitude in degrees, -90 to 90: 1 (first: " + at(5) + ": `null`)",
        "dropped, no longitude in degrees, -180 to 180: 1 (first: " + at(6) + ": `960`)",
        "dropped, no number of points, a whole number up to 10000: 1 (first: " + at(7) + ": `\"many\"`)",
        "dropped, no points: 1 (first: " + at(8) + ": `minus`)",
        "dropped, outside the regions: 1 (first: " + at(9) + ": `swapped`)",
        "dropped, no AddressInfo: 2 (first: " + at(10) + ": `null`)"}) {
    expect_reported(line);
  }
}

TEST_F(OpenChargeMap, IsRefusedWithWhatIsWrong) {
  expect_refused("[{\"ID\": 1},\n", "poi.json:1: is no JSON: it breaks off; is the file truncated?");
  expect_refused("{}\n{}\n", "poi.json:2: is no JSON: something follows its end; put all into one list");
  expect_refused("{}", "poi.json: is no list of stations, such as Open Charge Map exports");
  expect_refused("[]", "poi.json: has no station in a region");
  expect_refused("[" + entry("\"a\"", R"("Latitude": 9.71, "Longitude": 52.3475)", R"("NumberOfPoints": 2)") + "]",
                 "has no station in a region; one lies at 9.71, 52.3475, a region at 52.37, 9.74\n  dropped, outside");
}

}  // namespace
}  // namespace evbal
