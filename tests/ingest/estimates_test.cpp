#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tools/ingest/sessions.hpp"
#include "tools/ingest/stations.hpp"
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
  const SessionSample sample = read_sessions(folder.path(), "Rapid", 12.0, 90.0);
  EXPECT_EQ(sample.minutes, (std::vector<double>{20.0, 30.0}));
  EXPECT_EQ(sample.read, 6);
  EXPECT_EQ(sample.other_model, 1);
  EXPECT_EQ(sample.unfinished, 2);
  EXPECT_EQ(sample.out_of_range, 1);
  EXPECT_THROW(read_sessions(folder.path(), "Ultra", 12.0, 90.0), Error);
}

TEST(Quantiles, AreLinearBetweenOrderStatistics) {
  EXPECT_EQ(quantiles({1.0, 2.0, 4.0}, 5), (std::vector<double>{1.0, 1.5, 2.0, 3.0, 4.0}));
  EXPECT_EQ(quantiles({7.0}, 3), (std::vector<double>{7.0, 7.0, 7.0}));
}

}  // namespace
}  // namespace evbal
