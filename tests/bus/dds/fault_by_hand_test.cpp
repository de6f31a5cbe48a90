// Faults that are added while the day goes on: the injector says them from the next tick on.

#include "faults/schedule/by_hand.hpp"
#include "tests/bus/dds/toy_day.hpp"

#include <csignal>

namespace evbal {
namespace {

class FaultByHandOverDds : public test::ToyDay {
 protected:
  FaultByHandOverDds() {
    scenario_.world.clock.end = 11 * 60;
    scenario_.schedule = {};
    write_scenario();
  }

  std::string digest_by_hand() {
    DdsPlayers players({.folder = folder_.path(),
                        .regions = scenario_.world.city.size(),
                        .world = &scenario_.world,
                        .programs = EVBAL_PROGRAMS});
    return digest_of(
        players, [](const TickRecord&) {}, [&](int tick) { before(tick, players); });
  }

  void before(int tick, DdsPlayers& players) {
    if (tick == 0) {
      add(players, "{type: demand.scale, target: {regions: [1]}, duration: 20min, magnitude: 3}", tick);
    }
    if (tick == 10) {
      kill(players.process_id("faults"), SIGKILL);
      add(players, "{type: charger.outage, target: {regions: [0]}, duration: 30min, magnitude: {points: 2}}", tick);
      add(players, "{type: process.kill, target: {agent: 3}, restart_after: 15min}", tick);
    }
    if (tick == 20) {
      add(players, "{type: process.kill, target: {injector: true}, restart_after: 10min}", tick);
    }
    if (tick == 22) {
      add(players, "{type: travel.slow, target: {regions: [2]}, duration: 60min, magnitude: 2}", tick);
    }
  }

  void add(Players& players, const std::string& entry, int tick) {
    const Eigen::VectorXi points = scenario_.world.city.points();
    scenario_.schedule = with_fault_by_hand(scenario_.schedule, YamlValue::parse(entry, "entry"),
                                            {scenario_.world.clock, {points.begin(), points.end()}}, tick);
    write_scenario();
    players.amended(static_cast<int>(scenario_.schedule.faults.size()) - 1);
  }
};

TEST_F(FaultByHandOverDds, IsTheOneOfASchedule) {
  const std::string by_hand = digest_by_hand();
  EXPECT_EQ(by_hand, digest_in_process());
  EXPECT_EQ(by_hand, digest_over_dds(1));
}

}  // namespace
}  // namespace evbal
