#include "agents/protocol/fingerprint.hpp"
#include "agents/region/region_plant.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/conductor/roads.hpp"
#include "experiments/conductor/run_day.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace evbal {
namespace {

using test::faults_for;
using test::hold;
using test::no_faults;
using test::small_worlds;

class LyingPlayers : public Players {
 public:
  LyingPlayers(const World& world, std::function<void(Exchange&)> lie)
      : players_(
            world, [](const Tick& tick, const auto&) { return hold(tick.tick); }, no_faults),
        lie_(std::move(lie)) {}

  Faults faults(int tick) override { return players_.faults(tick); }

  Exchange play(const Tick& tick) override {
    Exchange said = players_.play(tick);
    if (tick.tick == 3) {
      lie_(said);
    }
    return said;
  }

 private:
  InprocPlayers players_;
  std::function<void(Exchange&)> lie_;
};

void expect_caught(const std::function<void(Exchange&)>& lie, const std::string& word) {
  const World world = test::world_of({}, {.plan_every = 5});
  LyingPlayers players(world, lie);
  try {
    run_day(world, players, [](const TickRecord&) {});
    FAIL() << "nobody noticed: " << word;
  } catch (const Error& error) {
    const std::string said = error.what();
    EXPECT_EQ(error.status(), ExitStatus::run_failed);
    EXPECT_NE(said.find("tick 3"), std::string::npos) << said;
    EXPECT_NE(said.find("region 2"), std::string::npos) << said;
    EXPECT_NE(said.find(word), std::string::npos) << said;
  }
}

TEST(RunDay, NoticesLostVehicles) {
  expect_caught([](Exchange& said) { --said.departures[2].vacant; }, "vehicles");
}

TEST(RunDay, NoticesPointsThatDoNotWork) {
  expect_caught([](Exchange& said) { said.departures[2].points = said.departures[2].plugged - 1; }, "points");
}

TEST(RunDay, NoticesVehiclesFromNowhere) {
  const auto send = [](int vehicle) {
    return [=](Exchange& said) {
      said.departures[2].departures.push_back(
          {.minute = 15, .to = 0, .arrival_minute = 40, .errand = Errand::rebalance, .vehicle = {.id = vehicle}});
    };
  };
  expect_caught(send(0), "was not there");
  expect_caught(send(60), "vehicle 60");
}

TEST(RunDay, NoticesPlansBeyondTheReports) {
  expect_caught(
      [](Exchange& said) { said.plan->moves.push_back({.from = 2, .to = 0, .count = said.reports[2].vacant + 1}); },
      "more vehicles");
}

}  // namespace
}  // namespace evbal
