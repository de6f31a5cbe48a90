#include "tools/ingest/ingest_rl4amod.hpp"

#include "agents/world/geometry.hpp"
#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tools/ingest/regions_by_distance.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

const std::string kPeerNotes = R"(name: small
source: nobody
step: 30min
days: {train: [2024-01-01], test: [2024-01-02], holidays: []}
demand_ratio: 4
seed: 1
kmh: 30
fleet: {vehicles: 6, battery_kwh: 40, km_per_kwh: 5.5, initial_charge: [1, 1], placement: even}
charging: {stations: 1, points: 2, power_kw: 50, session_quantiles: [12min, 30min]}
passengers: {patience: [1min, 4min]}
)";

/// Three regions, 22:00 to 24:00: 30 trips an hour from 0 to 1 in every minute, and one entry of none from 1 to 2.
std::string peer_scenario() {
  std::string demand;
  for (int minute = 22 * 60; minute < 24 * 60; ++minute) {
    demand += R"({"time_stamp": )" + std::to_string(minute) +
              R"(, "origin": 0, "destination": 1, "demand": 0.5, "travel_time": )" + (minute < 1380 ? "10" : "20") +
              R"(, "price": )" + (minute < 1380 ? "7.5" : "9") + "},\n";
  }
  demand += R"({"time_stamp": 1330, "origin": 1, "destination": 2, "demand": 0, "travel_time": 8, "price": 5})";
  std::string empty;
  for (int hour = 22; hour < 24; ++hour) {
    for (int pair = 0; pair < 9; ++pair) {
      empty += std::string(empty.empty() ? "" : ",\n") + R"({"time_stamp": )" + std::to_string(hour) +
               R"(, "origin": )" + std::to_string(pair / 3) + R"(, "destination": )" + std::to_string(pair % 3) +
               R"(, "reb_time": )" +
               (pair / 3 == pair % 3 ? "0.5"
                : hour == 22         ? "4"
                                     : "6") +
               "}";
    }
  }
  return R"({"nlat": 3, "nlon": 1, "demand": [)" + demand + R"(], "totalAcc": [{"hour": 22, "acc": 6},)" +
         R"( {"hour": 23, "acc": 5}], "rebTime": [)" + empty + R"(], "topology_graph": [{"i": 0, "j": 1}]})";
}

class IngestRl4amod : public testing::Test {
 protected:
  IngestRl4amod() {
    folder_.write("scenario.json", peer_scenario());
    folder_.write("notes.yaml", kPeerNotes);
  }

  Rl4amodCity ingest() const { return ingest_rl4amod(folder_.path() / "scenario.json", folder_.path() / "notes.yaml"); }

  /// Expects that the scenario, in which `now` stands for the first `was`, is refused with these words.
  void expect_refused(const std::string& was, const std::string& now, const std::string& words) const {
    std::string text = peer_scenario();
    const std::size_t at = text.find(was);
    ASSERT_NE(at, std::string::npos) << was;
    folder_.write("scenario.json", text.replace(at, was.size(), now));
    expect_bad_input("scenario.json: " + words);
  }

  /// Expects that what lies in the folder is refused with these words.
  void expect_bad_input(const std::string& words) const {
    try {
      ingest();
      FAIL() << "was accepted, without: " << words;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }

  Folder folder_;
};

TEST_F(IngestRl4amod, MakesACityOfIt) {
  const Rl4amodCity made = ingest();
  const City& city = made.made.city;
  ASSERT_EQ(city.size(), 3);
  EXPECT_EQ(city.day_start, 22 * 60);
  EXPECT_EQ(city.steps_per_day(), 4);
  EXPECT_EQ(city.minutes(0, 1), 15.0) << "passengers' time, mean over the trips";
  EXPECT_EQ(city.minutes(1, 2), 5.0) << "where nobody rides, that of empty cars, mean over the hours";
  EXPECT_EQ(city.minutes(2, 2), 1.0) << "a minute at least";
  EXPECT_EQ(city.km(0, 1), 7.5);
  EXPECT_EQ(city.fleet.placement, FleetPlacement::even);
  EXPECT_EQ(city.points().sum(), 2);
  EXPECT_EQ(made.prices, "step,origin,destination,price,minutes\n0,0,1,7.5,10\n1,0,1,7.5,10\n2,0,1,9,20\n3,0,1,9,20\n");
  EXPECT_NE(made.made.report.find("trips a day, mean: 240\n"), std::string::npos) << made.made.report;
}

TEST_F(IngestRl4amod, DrawsEveryDayAnewAndTheSameAgain) {
  const Rl4amodCity made = ingest();
  ASSERT_EQ(made.made.days.size(), 2U);
  std::vector<int> totals;
  for (const DemandDay& day : made.made.days) {
    totals.push_back(0);
    for (const auto& step : day.steps) {
      ASSERT_EQ(step.size(), 1U) << "60 trips are expected in each step from 0 to 1, and none from 1 to 2";
      EXPECT_NEAR(step.front().trips, 60, 40);
      totals.back() += step.front().trips;
    }
  }
  EXPECT_NE(totals[0], totals[1]);
  const Rl4amodCity again = ingest();
  EXPECT_EQ(again.made.days[1].steps[2].front().trips, made.made.days[1].steps[2].front().trips);
}

TEST_F(IngestRl4amod, GivesAPackThatIsReadBack) {
  const Rl4amodCity made = ingest();
  write_city(made.made.city, made.made.days, folder_.path() / "pack");
  const City city = read_city(folder_.path() / "pack");
  EXPECT_EQ(city.minutes, made.made.city.minutes);
  EXPECT_EQ(city.fleet.placement, FleetPlacement::even);
  EXPECT_EQ(read_demand(city, "2024-01-02").steps[0].front().trips, made.made.days[1].steps[0].front().trips);
}

TEST_F(IngestRl4amod, SaysWhatIsWrongAndWhere) {
  expect_refused(R"("origin": 0)", R"("origin": 3)", "demand[0].origin: a number from 0 to 2 is expected, not `3`");
  expect_refused(R"("origin": 0)", R"("origin": 0.5)", "demand[0].origin: a whole number is expected, not `0.5`");
  expect_refused(R"("demand": 0.5)", R"("demand": -1)", "demand[0].demand: a number from 0 to 10000 is expected");
  expect_refused(R"("demand": 0.5)", R"("demand": null)", "demand[0].demand: a number from 0 to 10000 is expected");
  expect_refused(R"("time_stamp": 1330)", R"("time_stamp": 1319)",
                 "demand[10].time_stamp: a number from 1320 to 1439 is expected, not `1319`");
  expect_refused(R"("price": 7.5)", R"("cost": 7.5)", "demand[0].price: a number from 0 to 1000000 is expected");
  expect_refused(R"("hour": 23)", R"("hour": 21)", "totalAcc[1]: hours are expected one after another, next 23");
  expect_refused(R"("nlat": 3)", R"("nlat": 4)", "rebTime: has no entry from region 0 to 3; every pair needs one");
  expect_refused(R"("totalAcc")", R"("acc")", "totalAcc: a list is expected, with an entry at least");
}

TEST_F(IngestRl4amod, NamesTheLineOfWhatIsNoJson) {
  std::string text = peer_scenario();
  folder_.write("scenario.json", text.replace(text.find(",\n"), 1, ";"));
  expect_bad_input("scenario.json:1: is no scenario of RL4AMOD");
}

TEST_F(IngestRl4amod, RefusesNotesThatDoNotFit) {
  std::string notes = kPeerNotes;
  folder_.write("notes.yaml", notes.replace(notes.find("step: 30min"), 11, "step: 45min"));
  expect_bad_input("notes.yaml:3: step must divide an hour");
}

TEST(RegionsByDistance, StandAsFarApartAsTheirDistances) {
  Eigen::MatrixXd km(3, 3);
  km << 9.0, 3.0, 5.0, 3.0, 9.0, 4.0, 5.0, 4.0, 9.0;  // a right angle at the second; the diagonal does not count
  const std::vector<Region> regions = regions_by_distance(km);
  ASSERT_EQ(regions.size(), 3U);
  const LocalFrame frame(regions[1].centroid);
  EXPECT_NEAR(distance(frame.local(regions[0].centroid), {}), 3000.0, 3.0);
  EXPECT_NEAR(distance(frame.local(regions[2].centroid), {}), 4000.0, 3.0);
  EXPECT_EQ(regions[2].name, "r2");
  EXPECT_EQ(regions_by_distance(Eigen::MatrixXd::Ones(1, 1)).size(), 1U);
}

}  // namespace
}  // namespace evbal
