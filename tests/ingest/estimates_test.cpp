#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tests/support/source_folder.hpp"
#include "tools/ingest/sessions.hpp"
#include "tools/ingest/stations.hpp"
#include "tools/ingest/time_pattern.hpp"
#include "tools/ingest/travel.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

constexpr LatLon kOrigin{37.75, -122.45};

TEST(Travel, FindsTheLawAndFillsEveryPair) {
  const LocalFrame frame(kOrigin);
  TravelSums sums(3, kOrigin);
  for (int k = 1; k <= 50; ++k) {
    const double km = 0.1 * k;
    const Trip trip{0, 0, frame.global({0.0, 10.0 * k}), frame.global({3000.0, -10.0 * k}), 4.0 + 2.0 * km, km};
    sums.add(0, 1, trip);
  }
  EXPECT_NEAR(sums.law().start, 4.0, 1e-9);
  EXPECT_NEAR(sums.law().per_km, 2.0, 1e-9);
  const auto centroids = sums.centroids({kOrigin, kOrigin, frame.global({0.0, 9000.0})});
  const auto matrices = sums.matrices(centroids, 1.3, 10.0);
  EXPECT_GT(matrices.km.minCoeff(), 0.0);
  EXPECT_GE(matrices.minutes.minCoeff(), 1.0);
  EXPECT_NEAR(matrices.km(2, 2), 0.1, 1e-9) << "no trip ends there: no spread";
  EXPECT_NEAR(matrices.minutes(2, 0), 4.0 + 2.0 * matrices.km(2, 0), 1e-9) << "unseen: by the law";
  const double straight = distance(frame.local(centroids[0]), frame.local(centroids[2])) / 1000.0;
  EXPECT_GT(matrices.km(2, 0), 1.3 * straight) << "the ends are spread around the centroid";
  EXPECT_LT(matrices.km(2, 0), 1.3 * straight * 1.01);
  EXPECT_LT(std::abs(matrices.km(0, 1) - 2.55), std::abs(matrices.km(1, 0) - 2.55)) << "seen: nearer to its mean";
}

TEST(Stations, AreSpreadOutAndWeighted) {
  // Regions on a line, 1 km apart; demand at both ends, more at the left one.
  Eigen::MatrixXd km(7, 7);
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 7; ++j) {
      km(i, j) = std::max(0.3, 1.0 * std::abs(i - j));
    }
  }
  Eigen::VectorXd demand(7);
  demand << 6, 1, 1, 1, 1, 1, 3;
  const auto one = choose_stations(km, demand, 1, 5);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].points, 5);
  const auto three = choose_stations(km, demand, 3, 7);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_LE(three.front().region, 1);
  EXPECT_GE(three.back().region, 5);
  int points = 0;
  for (const auto& station : three) {
    EXPECT_GE(station.points, 1);
    points += station.points;
  }
  EXPECT_EQ(points, 7);
  EXPECT_EQ(choose_stations(km, demand, 7, 7).size(), 7U);
}

TEST(Sessions, AreThoseOfTheModelAndOfAllowedLength) {
  const Folder folder;
  folder.write(
      "a.csv",
      "Charging event,CP ID,Connector,Start Date,Start Time,End Date,End Time,Total kWh,Cost,Site,Group,Model\n"
      "1,5,2,01/12/2017,23:50,02/12/2017,00:20,9,0,\"A Street, Dundee\",g,APT Triple Rapid Charger\n"
      "2,5,2,01/12/2017,12:00,01/12/2017,12:20,9,0,x,g,APT Triple Rapid Charger\n"
      "3,5,2,01/12/2017,12:00,01/12/2017,12:03,9,0,x,g,APT Triple Rapid Charger\n"
      "4,5,2,01/12/2017,12:00,,,9,0,x,g,APT Triple Rapid Charger\n"
      "5,5,2,31/02/2017,12:00,31/02/2017,12:30,9,0,x,g,APT Triple Rapid Charger\n"
      "6,5,2,01/12/2017,12:00,01/12/2017,12:30,9,0,x,g,APT 7kW Dual Outlet\n");
  folder.write("places.csv", "Latitude,Longitude\n56,-3\n");
  const SessionSample sample = read_sessions(folder.path(), dundee_session_format(), {"Rapid", 12.0, 90.0});
  EXPECT_EQ(sample.minutes, (std::vector<double>{20.0, 30.0}));
  const std::string first = " (first: " + (folder.path() / "a.csv").string();
  EXPECT_EQ(sample.report,
            "session rows read: 6\n"
            "  dropped, another model of charger: 1" +
                first +
                ":7: `APT 7kW Dual Outlet`)\n"
                "  dropped, no start or no end: 1" +
                first +
                ":5: ` `)\n"
                "  dropped, no time like `%d/%m/%Y %H:%M`: 1" +
                first +
                ":6: `31/02/2017 12:00`)\n"
                "  dropped, not from 12 to 90 min long: 1" +
                first +
                ":4: `3 min`)\n"
                "  tables without these columns, not read: 1 (first: " +
                (folder.path() / "places.csv").string() +
                ")\n"
                "sessions used: 2, median 25 min\n");
  try {
    read_sessions(folder.path(), dundee_session_format(), {"Ultra", 12.0, 90.0});
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("model `Ultra` and of allowed length\n  dropped, another model"),
              std::string::npos)
        << error.what();
  }
}

TEST(Sessions, AreReadByDescription) {
  const Folder folder;
  folder.write("gps/charging.csv",
               "cab,station,region,arrival_unix,start_unix,end_unix\n"
               "7,s,r,1211139600,1211140500,1211143740\n"
               "7,s,r,1211139600,1211140500,\n");
  const auto format = folder.write("format.yaml", "columns: {start: start_unix, end: end_unix}\ntime: unix\n");
  const SessionSample sample = read_sessions(folder.path() / "gps", read_session_format(format), {"none", 1.0, 90.0});
  EXPECT_EQ(sample.minutes, (std::vector<double>{54.0}));
  const auto refused = [&](const std::string& text, const std::string& reason) {
    try {
      read_sessions(folder.path() / "gps", read_session_format(folder.write("format.yaml", text)), {"none", 1.0, 90.0});
      FAIL() << "was accepted";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  };
  refused("columns: {start: begin, end: end_unix}\ntime: unix\n", "charging.csv:1: has no column `begin`");
  refused("columns: {start: start_unix, end: end_unix}\ntime: \"%d.%m.%y\"\n", "none of %Y %m %d %H %M %S");
  refused("columns: {start: start_unix, end: end_unix}\ntime: \"%d.%m.%Y\"\n", "format.yaml:2: `%d.%m.%Y` lacks %H");
  refused("columns: {start: start_unix, end: end_unix}\ntime: \"%Y-%m-%d %H:%M\"\n",
          "charging.csv:2: no time like `%Y-%m-%d %H:%M`: `1211140500`; none of 2 rows can be read");
}

TEST(TimeLike, FollowsItsPattern) {
  EXPECT_EQ(time_like("%d/%m/%Y %H:%M", "01/03/2024 12:05"), 1709294700);
  EXPECT_EQ(time_like("%m/%d/%Y %H:%M:%S", "3/1/2024 9:05:07"), 1709283907);
  EXPECT_EQ(time_like("%d/%m/%Y %H:%M", "01/13/2024 12:05"), std::nullopt);
  EXPECT_EQ(time_like("%d/%m/%Y %H:%M", "01/03/2024 12:05 "), std::nullopt);
  EXPECT_EQ(time_like("%d/%m/%Y %H:%M", "01/03/2024 24:05"), std::nullopt);
  EXPECT_EQ(time_like("%d/%m/%Y %H:%M", "01/03/2024"), std::nullopt);
}

TEST(DundeeSessionFormat, IsTheOneThatIsShipped) {
  const SessionFormat shipped = read_session_format(test::in_source("tools/ingest/dundee.yaml"));
  const SessionFormat built_in = dundee_session_format();
  EXPECT_EQ(shipped.table.columns, built_in.table.columns);
  EXPECT_EQ(shipped.time, built_in.time);
  EXPECT_EQ(shipped.charger, built_in.charger);
}

TEST(Quantiles, AreLinearBetweenOrderStatistics) {
  EXPECT_EQ(quantiles({1.0, 2.0, 4.0}, 5), (std::vector<double>{1.0, 1.5, 2.0, 3.0, 4.0}));
  EXPECT_EQ(quantiles({7.0}, 3), (std::vector<double>{7.0, 7.0, 7.0}));
}

}  // namespace
}  // namespace evbal
