#include "agents/world/city.hpp"
#include "agents/world/synthetic.hpp"
#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;

void expect_equal(const City& a, const City& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.source, b.source);
  EXPECT_EQ(a.day_start, b.day_start);
  EXPECT_EQ(a.step_minutes, b.step_minutes);
  EXPECT_EQ(a.km, b.km);
  EXPECT_EQ(a.minutes, b.minutes);
  EXPECT_EQ(a.days, b.days);
  EXPECT_EQ(a.train_days, b.train_days);
  EXPECT_EQ(a.test_days, b.test_days);
  EXPECT_EQ(a.holidays, b.holidays);
  EXPECT_EQ(a.fleet.vehicles, b.fleet.vehicles);
  EXPECT_EQ(a.fleet.battery_kwh, b.fleet.battery_kwh);
  EXPECT_EQ(a.fleet.km_per_kwh, b.fleet.km_per_kwh);
  EXPECT_EQ(a.fleet.initial_charge_low, b.fleet.initial_charge_low);
  EXPECT_EQ(a.fleet.initial_charge_high, b.fleet.initial_charge_high);
  EXPECT_EQ(a.charging.power_kw, b.charging.power_kw);
  EXPECT_EQ(a.charging.session_quantiles, b.charging.session_quantiles);
  EXPECT_EQ(a.passengers.patience_low, b.passengers.patience_low);
  EXPECT_EQ(a.passengers.patience_high, b.passengers.patience_high);
  ASSERT_EQ(a.stations.size(), b.stations.size());
  for (std::size_t s = 0; s < a.stations.size(); ++s) {
    EXPECT_EQ(a.stations[s].name, b.stations[s].name);
    EXPECT_EQ(a.stations[s].region, b.stations[s].region);
    EXPECT_EQ(a.stations[s].points, b.stations[s].points);
    EXPECT_EQ(a.stations[s].place.lat, b.stations[s].place.lat);
    EXPECT_EQ(a.stations[s].place.lon, b.stations[s].place.lon);
  }
  ASSERT_EQ(a.size(), b.size());
  for (int i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.regions[i].name, b.regions[i].name);
    EXPECT_EQ(a.regions[i].centroid.lat, b.regions[i].centroid.lat);
    EXPECT_EQ(a.regions[i].centroid.lon, b.regions[i].centroid.lon);
    ASSERT_EQ(a.regions[i].outline.size(), b.regions[i].outline.size());
    for (std::size_t r = 0; r < a.regions[i].outline.size(); ++r) {
      ASSERT_EQ(a.regions[i].outline[r].size(), b.regions[i].outline[r].size());
      for (std::size_t p = 0; p < a.regions[i].outline[r].size(); ++p) {
        EXPECT_EQ(a.regions[i].outline[r][p].lat, b.regions[i].outline[r][p].lat);
        EXPECT_EQ(a.regions[i].outline[r][p].lon, b.regions[i].outline[r][p].lon);
      }
    }
  }
}

void expect_equal(const DemandDay& a, const DemandDay& b) {
  EXPECT_EQ(a.date, b.date);
  EXPECT_EQ(a.holiday, b.holiday);
  ASSERT_EQ(a.steps.size(), b.steps.size());
  for (std::size_t step = 0; step < a.steps.size(); ++step) {
    ASSERT_EQ(a.steps[step].size(), b.steps[step].size());
    for (std::size_t c = 0; c < a.steps[step].size(); ++c) {
      EXPECT_EQ(a.steps[step][c].origin, b.steps[step][c].origin);
      EXPECT_EQ(a.steps[step][c].destination, b.steps[step][c].destination);
      EXPECT_EQ(a.steps[step][c].trips, b.steps[step][c].trips);
    }
  }
}

SyntheticOptions any_options() {
  SyntheticOptions options;
  options.regions = *rc::gen::inRange(1, 12);
  options.train_days = *rc::gen::inRange(0, 3);
  options.test_days = *rc::gen::inRange(1, 3);
  options.seed = *rc::gen::arbitrary<std::uint64_t>();
  options.trips_per_day = *rc::gen::inRange(0, 3000);
  options.stations = *rc::gen::inRange(0, options.regions + 1);
  options.points = options.stations + *rc::gen::inRange(0, 5);
  return options;
}

RC_GTEST_PROP(Pack, ReadsBackWhatWasWritten, ()) {
  SyntheticCity made = synthetic_city(any_options());
  made.city.name = *rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::inRange(' ', '~')));
  made.city.source = *rc::gen::container<std::string>(rc::gen::inRange(' ', '~'));
  made.city.regions.front().name = made.city.name;
  made.city.km(0, 0) = *rc::gen::map(rc::gen::inRange(1, 1'000'000), [](int n) { return n / 7777.0 + 0.001; });
  made.city.charging.session_quantiles = {1.0 + 1.0 / 3.0, 2.0, 100.0 / 7.0};
  if (*rc::gen::arbitrary<bool>()) {
    made.city.holidays = {made.city.days.front()};
    made.days.front().holiday = true;
  }
  const Folder folder;
  write_city(made.city, made.days, folder.path() / "pack");
  const City city = read_city(folder.path() / "pack");
  expect_equal(made.city, city);
  for (std::size_t d = 0; d < city.days.size(); ++d) {
    expect_equal(made.days[d], read_demand(city, city.days[d]));
  }
  RC_ASSERT(!testing::Test::HasFailure());
}

/// A small pack on disk, and what happens when it is spoilt.
class SpoiltPack : public testing::Test {
 protected:
  SpoiltPack() {
    SyntheticOptions options;
    options.train_days = 1;
    options.test_days = 1;
    const SyntheticCity made = synthetic_city(options);
    write_city(made.city, made.days, pack_);
  }

  void replace(const std::string& file, const std::string& from, const std::string& to) {
    std::string text = text_of(pack_ / file);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << file << " has no " << from;
    std::ofstream(pack_ / file) << text.replace(at, from.size(), to);
  }

  void read_all() const {
    const City city = read_city(pack_);
    for (const auto& date : city.days) {
      read_demand(city, date);
    }
  }

  void expect_refused(const std::string& place, const std::string& reason) const {
    try {
      read_all();
      FAIL() << "was accepted, expected a refusal at " << place;
    } catch (const Error& error) {
      const std::string what = error.what();
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      EXPECT_EQ(what.find((pack_ / place).string() + ": "), 0U) << what;
      EXPECT_NE(what.find(reason), std::string::npos) << what;
    }
  }

  Folder folder_;
  fs::path pack_ = folder_.path() / "pack";
};

TEST_F(SpoiltPack, IsReadWhileSound) {
  EXPECT_NO_THROW(read_all());
}

TEST_F(SpoiltPack, NamesTheLineOfAnUnknownRegion) {
  replace("city.yaml", "region: \"r1\"", "region: \"r9\"");
  expect_refused("city.yaml:21", "`r9` is not known");
}

TEST_F(SpoiltPack, RefusesAnUnknownKey) {
  replace("city.yaml", "  battery_kwh:", "  vehicels: 3\n  battery_kwh:");
  expect_refused("city.yaml:12", "unknown key `vehicels` (did you mean `vehicles`?)");
}

TEST_F(SpoiltPack, RefusesAMissingUnit) {
  replace("city.yaml", "[8min, 20min]", "[8, 20min]");
  expect_refused("city.yaml:19", "no duration");
}

TEST_F(SpoiltPack, RefusesAPatienceThatNoCounterHolds) {
  replace("city.yaml", "[8min, 20min]", "[8min, 99999999999h]");
  expect_refused("city.yaml:19", "24h");
}

TEST_F(SpoiltPack, RefusesNamesThatAreNoText) {
  replace("city.yaml", "region: \"r1\"", "region: \"r1\\nx\"");
  expect_refused("city.yaml:21", "line break");
  replace("city.yaml", "region: \"r1\\nx\"", "region: \"r1\"");
  replace("regions.geojson", "\"r1\"", "\"r\xff\"");
  expect_refused("regions.geojson:2", "UTF-8");
}

TEST_F(SpoiltPack, RefusesAnotherNumberOfRegions) {
  replace("city.yaml", "regions: 5", "regions: 54");
  expect_refused("city.yaml:23", "has 5 regions");
}

TEST_F(SpoiltPack, RefusesAnOpenRing) {
  replace("regions.geojson", "\"coordinates\":[[[[-", "\"coordinates\":[[[[");
  expect_refused("regions.geojson:2", "a ring");
}

TEST_F(SpoiltPack, RefusesAMissingPair) {
  replace("travel.csv", "\n2,3,", "\n2,4,");
  expect_refused("travel.csv:15", "expected pair 2,3");
}

TEST_F(SpoiltPack, RefusesARegionOutOfRange) {
  std::string text = text_of(pack_ / "demand/2024-01-01.csv");
  const std::size_t line = text.find('\n') + 1;
  const std::size_t comma = text.find(',', line);
  std::ofstream(pack_ / "demand/2024-01-01.csv") << text.replace(comma + 1, 1, "5");
  expect_refused("demand/2024-01-01.csv:2", "origin `5` must be a whole number from 0 to 4");
}

TEST_F(SpoiltPack, RefusesAMissingFile) {
  fs::remove(pack_ / "travel.csv");
  expect_refused("travel.csv", "cannot be read");
}

TEST_F(SpoiltPack, NamesTheDaysItHas) {
  try {
    read_demand(read_city(pack_), "2024-02-01");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("2024-01-01, 2024-01-02"), std::string::npos) << error.what();
  }
}

// Wherever a file of a pack breaks off, the pack is refused; only the very last newline may be missing where YAML does
// not care for it.
TEST_F(SpoiltPack, RefusesTruncationAnywhere) {
  for (const std::string file : {"city.yaml", "regions.geojson", "travel.csv", "demand/2024-01-02.csv"}) {
    const std::string text = text_of(pack_ / file);
    const std::size_t stride = text.size() / 50 + 1;
    for (std::size_t cut = 0; cut + 1 < text.size(); cut += stride) {
      std::ofstream(pack_ / file) << text.substr(0, cut);
      EXPECT_THROW(read_all(), Error) << file << " cut after " << cut << " bytes";
    }
    std::ofstream(pack_ / file) << text;
  }
  EXPECT_NO_THROW(read_all());
}

TEST_F(SpoiltPack, IsNotOverwritten) {
  const SyntheticCity made = synthetic_city({});
  EXPECT_THROW(write_city(made.city, made.days, pack_), Error);
  EXPECT_NO_THROW(read_all());
  EXPECT_EQ(read_city(pack_).days.size(), 2U);
}

TEST(Synthetic, SameSeedSameCity) {
  const SyntheticCity a = synthetic_city({});
  const SyntheticCity b = synthetic_city({});
  expect_equal(a.city, b.city);
  for (std::size_t d = 0; d < a.days.size(); ++d) {
    expect_equal(a.days[d], b.days[d]);
  }
  SyntheticOptions other;
  other.seed = 2;
  EXPECT_NE(synthetic_city(other).city.km, a.city.km);
}

TEST(Synthetic, ShippedToyIsWhatTheDefaultsGive) {
  const SyntheticCity made = synthetic_city({});
  const City city = read_city(test::in_source("experiments/cities/toy-5"));
  expect_equal(made.city, city);
  for (std::size_t d = 0; d < made.days.size(); ++d) {
    expect_equal(made.days[d], read_demand(city, made.days[d].date));
  }
}

TEST(Synthetic, HasTheTripsItWasAskedFor) {
  SyntheticOptions options;
  options.train_days = 28;
  double trips = 0.0;
  const SyntheticCity made = synthetic_city(options);
  for (const auto& day : made.days) {
    for (const auto& step : day.steps) {
      for (const auto& count : step) {
        trips += count.trips;
      }
    }
  }
  EXPECT_NEAR(trips / static_cast<double>(made.days.size()), options.trips_per_day, 0.1 * options.trips_per_day);
}

TEST(City, NearestStationIsByRoadAndItselfFirst) {
  SyntheticOptions options;
  City city = synthetic_city(options).city;
  city.stations = {{"a", 1, 2, {}}, {"b", 3, 1, {}}, {"c", 3, 2, {}}};
  city.km.setConstant(5.0);
  city.km(0, 3) = 4.0;
  city.km(3, 1) = 1.0;
  EXPECT_EQ(city.points(), (Eigen::VectorXi(5) << 0, 2, 0, 3, 0).finished());
  EXPECT_EQ(city.nearest_station(), (std::vector<int>{3, 1, 1, 3, 1}));
  city.stations.clear();
  EXPECT_EQ(city.nearest_station(), std::vector<int>(5, -1));
}

}  // namespace
}  // namespace evbal
