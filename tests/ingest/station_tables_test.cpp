// Lists of stations as authorities and networks publish them.

#include "agents/world/geometry.hpp"
#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tools/ingest/ingest_stations.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

const std::string kColumns = "columns: {name: id, lat: latitude, lon: longitude, points: points}\n";
const std::string kHeader = "id,latitude,longitude,points\n";

class StationTables : public testing::Test {
 protected:
  /// "name points" of each station, in the order of the table.
  std::vector<std::string> ingest(const std::string& table, const std::string& format = kColumns) {
    const std::vector<Region> all{
        {"all", {{{52.34, 9.70}, {52.34, 9.78}, {52.40, 9.78}, {52.40, 9.70}}}, {52.37, 9.74}}};
    YamlMap map(YamlValue::parse(format, "format.yaml"));
    const auto made = ingest_stations(folder_.write("list.csv", table), read_station_format(map), all, 500.0);
    report_ = made.report;
    std::vector<std::string> stations;
    for (const Station& station : made.stations) {
      stations.push_back(station.name + " " + std::to_string(station.points));
    }
    return stations;
  }

  std::string refusal(const std::string& table, const std::string& format = kColumns) {
    try {
      ingest(table, format);
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      return error.what();
    }
    return "was accepted";
  }

  void expect_reported(const std::string& line) const {
    EXPECT_NE(report_.find(line), std::string::npos) << line << " not in\n" << report_;
  }

  std::string at(int line) const { return (folder_.path() / "list.csv").string() + ":" + std::to_string(line); }

  Folder folder_;
  std::string report_;
};

using Stations = std::vector<std::string>;

TEST_F(StationTables, WithARowForEachConnectorAddUp) {
  EXPECT_EQ(ingest(kHeader + "FR*V07*E1*1,52.34750,9.71000,1\n"
                             "FR*V07*E2*1,52.36250,9.73000,1\n"
                             "FR*V07*E1*1,52.34750,9.71000,1\n"
                             "FR*V07*E1*1,52.34760,9.71010,1\n"
                             "FR*V07*E2*1,52.36250,9.73000,1\n"),
            (Stations{"FR*V07*E1*1 3", "FR*V07*E2*1 2"}));
  expect_reported("further rows of a station, points added up: 3 (first: " + at(4) + ": `FR*V07*E1*1`)");
}

TEST_F(StationTables, OfOneChainFarApartAreSeveral) {
  EXPECT_EQ(ingest(kHeader + "Supermarket,52.34750,9.71000,4\n"
                             "Supermarket,52.37750,9.75000,2\n"
                             "Supermarket 2,52.39000,9.71000,1\n"
                             "Town hall,52.34750,9.77000,1\n"
                             "Supermarket,52.37750,9.75000,2\n"),
            (Stations{"Supermarket 4", "Supermarket 2 4", "Supermarket 2 2 1", "Town hall 1"}));
  expect_reported("of a name that another station has, numbered: 2 (first: " + at(3) +
                  ": `Supermarket` is `Supermarket 2`)");
}

TEST_F(StationTables, ListedTwiceUnderTwoNamesAreTold) {
  EXPECT_EQ(ingest(kHeader + "ocm-1,52.34750,9.71000,4\nafdc-77,52.34750,9.71000,4\n"),
            (Stations{"ocm-1 4", "afdc-77 4"}));
  expect_reported("listed twice?: 1 (first: " + at(3) + ": `afdc-77` beside `ocm-1`)");
}

TEST_F(StationTables, MayHavePointsAsOtherProgramsWriteThem) {
  EXPECT_EQ(ingest(kHeader + "a,52.34750,9.71000,2.0\nb,52.34750,9.73000,\nc,52.34750,9.75000,4.0\n"),
            (Stations{"a 2", "c 4"}));
  expect_reported("dropped, no number of points told: 1 (first: " + at(3) + ": `b`)");
  EXPECT_EQ(ingest("ID,Station Name,Latitude,Longitude,EV Level2 EVSE Num,EV DC Fast Count\n"
                   "168524,Garage,52.35,9.71,2,\n"
                   "205858,Plaza,52.36,9.71,,3\n"
                   "205859,Both,52.37,9.71,4,1\n"
                   "205860,None,52.38,9.71,,\n",
                   "columns: {name: Station Name, lat: Latitude, lon: Longitude,\n"
                   "          points: [EV Level2 EVSE Num, EV DC Fast Count]}\n"),
            (Stations{"Garage 2", "Plaza 3", "Both 5"}));
  EXPECT_NE(
      refusal(kHeader, "columns: {name: id, lat: latitude, lon: longitude, points: []}\n").find("list of columns"),
      std::string::npos);
}

TEST_F(StationTables, WithDecimalCommasNeedTheWord) {
  const std::string table = "id;latitude;longitude;points\na;52,34750;9,71000;2\nb;52,34750;9,73000;4,0\n";
  const std::string refused = refusal(table, "separator: semicolon\n" + kColumns);
  EXPECT_NE(refused.find("`52,34750`"), std::string::npos) << refused;
  EXPECT_NE(refused.find("-90 to 90: 2 (first: " + at(2)), std::string::npos) << refused;
  EXPECT_EQ(ingest(table, "separator: semicolon\ndecimal: comma\n" + kColumns), (Stations{"a 2", "b 4"}));
  EXPECT_NE(refusal(kHeader + "a,52.35,9.71,2\n", "separator: semicolon\n" + kColumns).find("has no column `id`"),
            std::string::npos);
}

TEST_F(StationTables, OfOtherBytesAreDroppedWithAReason) {
  EXPECT_EQ(ingest(kHeader + "Stra\xDF"
                             "e,52.34750,9.71000,2\nplain,52.34750,9.73000,4\n"),
            (Stations{"plain 4"}));
  expect_reported("dropped, name is not UTF-8: 1 (first: " + at(2) + ": `Stra?e`)");
}

TEST_F(StationTables, WithOddRowsKeepTheOthers) {
  EXPECT_EQ(ingest(kHeader + "zero,52.34750,9.71000,0\n"
                             "neg,52.34750,9.71000,-1\n"
                             "swapped,9.71000,52.34750,2\n"
                             "null,0,0,2\n"
                             "ok,52.34750,9.71000,2\n"
                             "quoted,\"52.34750\",\"9.73000\",\"1,000\"\n"
                             ",52.34750,9.71000,2\n"),
            (Stations{"ok 2"}));
  expect_reported("dropped, no points: 2 (first: " + at(2) + ": `zero`)");
  expect_reported("dropped, outside the regions: 2 (first: " + at(4) + ": `swapped`)");
  expect_reported("dropped, no number of points, a whole number up to 10000: 1 (first: " + at(7) + ": `1,000`)");
  expect_reported("dropped, no name: 1 (first: " + at(8) + ": `52.3475, 9.71`)");
}

TEST_F(StationTables, MayHaveLineBreaksInQuotes) {
  EXPECT_EQ(ingest("id,address,latitude,longitude,points\n"
                   "\"a\",\"Main Street 1\nBack yard\",52.34750,9.71000,2\n"
                   "\"b\nby the \"\"sea\"\"\",\"x\",52.34750,9.73000,4\n"),
            (Stations{"a 2", "b by the \"sea\" 4"}));
}

}  // namespace
}  // namespace evbal
