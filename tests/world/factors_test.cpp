#include "agents/world/factors.hpp"

#include "agents/world/synthetic.hpp"
#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// Two regions, 200 days, two trips from 0 to 1 for each one back, twice as many in the second half of the day.
City city_of_factors() {
  SyntheticOptions options;
  options.regions = 2;
  options.stations = 1;
  options.train_days = 198;
  options.test_days = 2;
  City city = synthetic_city(options).city;
  CityFactors& factors = city.factors.emplace();
  factors.pairs = {{0, 0, 100}, {0, 1, 2000}, {1, 0, 1000}};
  factors.share = 0.5;
  factors.course = Eigen::MatrixXd::Constant(200, city.steps_per_day(), 0.01);
  factors.course.rightCols(city.steps_per_day() / 2).setConstant(0.02);
  factors.region_deviation = 0.2;
  factors.seed = 5;
  factors.detour = 1.5;
  factors.start_minutes = 4.0;
  factors.minutes_per_km = 2.0;
  factors.spread_km = {0.3, 0.4};
  set_travel(city);
  return city;
}

/// Trips by origin and destination, in the steps [first, last).
Eigen::Matrix2d trips_of(const DemandDay& day, std::size_t first, std::size_t last) {
  Eigen::Matrix2d trips = Eigen::Matrix2d::Zero();
  for (std::size_t step = first; step < last; ++step) {
    for (const TripCount& pair : day.steps[step]) {
      trips(pair.origin, pair.destination) += pair.trips;
    }
  }
  return trips;
}

TEST(Factors, TravelIsThatOfRandomPlaces) {
  const City city = city_of_factors();
  EXPECT_NEAR(city.km(0, 0), 1.5 * std::sqrt(2.0) * 0.3, 0.005);
  EXPECT_GT(city.km(0, 1), 1.5 * 0.5);
  EXPECT_EQ(city.km(0, 1), city.km(1, 0));
  EXPECT_DOUBLE_EQ(city.minutes(0, 1), 4.0 + 2.0 * city.km(0, 1));
}

TEST(Factors, DaysVaryAroundTheirProduct) {
  const City city = city_of_factors();
  const auto steps = static_cast<std::size_t>(city.steps_per_day());
  Eigen::Matrix2d morning = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d evening = Eigen::Matrix2d::Zero();
  double square = 0.0;
  for (const auto& date : city.days) {
    const DemandDay day = drawn_day(city, date);
    const Eigen::Matrix2d early = trips_of(day, 0, steps / 2);
    const Eigen::Matrix2d late = trips_of(day, steps / 2, steps);
    morning += early / 200.0;
    evening += late / 200.0;
    square += std::pow((early + late)(0, 1), 2.0) / 200.0;
  }
  const double half = static_cast<double>(steps) / 2.0;
  EXPECT_NEAR(morning(0, 1), 0.5 * 2000 * 0.01 * half, 0.06 * morning(0, 1));
  EXPECT_NEAR(evening(0, 1), 2.0 * morning(0, 1), 0.06 * evening(0, 1));
  EXPECT_NEAR(morning(1, 0), morning(0, 1) / 2.0, 0.06 * morning(0, 1));
  EXPECT_EQ(morning(1, 1), 0.0);
  const double mean = (morning + evening)(0, 1);
  EXPECT_NEAR(std::sqrt(square - mean * mean) / mean, std::sqrt(0.2 * 0.2 + 1.0 / mean), 0.04);
}

TEST(Factors, AreWrittenInPlaceOfTables) {
  const City city = city_of_factors();
  const Folder folder;
  write_city(city, {}, folder.path() / "pack");
  EXPECT_FALSE(fs::exists(folder.path() / "pack/travel.csv"));
  const City read = read_city(folder.path() / "pack");
  EXPECT_EQ(read.km, city.km);
  EXPECT_EQ(read.minutes, city.minutes);
  EXPECT_EQ(read.factors->course, city.factors->course);
  EXPECT_EQ(read.factors->spread_km, city.factors->spread_km);
  const DemandDay written = drawn_day(city, city.days[7]);
  const DemandDay drawn = read_demand(read, city.days[7]);
  const auto steps = drawn.steps.size();
  EXPECT_EQ(trips_of(drawn, 0, steps), trips_of(written, 0, steps));
  EXPECT_NE(trips_of(drawn, 0, steps), trips_of(read_demand(read, city.days[8]), 0, steps));
  EXPECT_THROW(read_demand(read, "2030-01-01"), Error);
}

TEST(Factors, AreRefusedWhereverTheirFilesBreakOff) {
  const Folder folder;
  const fs::path pack = folder.path() / "pack";
  write_city(city_of_factors(), {}, pack);
  for (const std::string file : {"demand/pairs.csv", "demand/course.csv", "spread.csv"}) {
    const std::string text = text_of(pack / file);
    for (std::size_t cut = 0; cut < text.size(); cut += text.size() / 20 + 1) {
      std::ofstream(pack / file) << text.substr(0, cut);
      EXPECT_THROW(read_city(pack), Error) << file << " cut after " << cut << " bytes";
    }
    std::ofstream(pack / file) << text;
  }
  EXPECT_NO_THROW(read_city(pack));
}

}  // namespace
}  // namespace evbal
