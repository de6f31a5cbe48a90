// Processes that a schedule takes away, by real signals, and samples that it loses: the day is the one in this process.

#include "tests/bus/dds/toy_day.hpp"

#include <map>

namespace evbal {
namespace {

class ScheduledAbsenceTest : public test::ToyDay {
 protected:
  ScheduledAbsenceTest() {
    scenario_.world.clock.end = 11 * 60;
    scenario_.schedule = {};
  }

  /// Minutes from 05:00.
  Fault& add(EffectType type, int start, int duration, int region = no_region) {
    Fault fault;
    fault.name = "fault-" + std::to_string(scenario_.schedule.faults.size());
    fault.type = type;
    fault.regions = {region};
    fault.magnitudes = {0.0};
    fault.start = start;
    fault.duration = duration;
    return scenario_.schedule.faults.emplace_back(fault);
  }

  void add(EffectType type, int start, int duration, ProcessRole process) {
    add(type, start, duration).process = process;
  }

  std::set<std::int64_t> writers_of(const std::vector<TickRecord>& day, std::size_t region) const {
    std::set<std::int64_t> ids;
    for (const auto& record : day) {
      ids.insert(record.exchange.departures[region].origin.process_id);
    }
    return ids;
  }
};

TEST_F(ScheduledAbsenceTest, IsTheSameOverDds) {
  using enum EffectType;
  using enum ProcessRole;
  add(process_slow, 30, 30, 2).magnitudes = {3.0};
  add(process_kill, 60, 30, 1);
  add(process_pause, 70, 40, 3);
  add(process_kill, 80, 20, coordinator);
  add(process_pause, 120, 25, coordinator);
  add(process_slow, 150, 10, coordinator);
  scenario_.schedule.faults.back().magnitudes = {5.0};
  add(charger_outage, 175, 10, 0).magnitudes = {2.0};
  add(process_kill, 180, 15, injector);
  add(demand_scale, 185, 10, 1).magnitudes = {3.0};
  add(process_pause, 210, 20, injector);
  add(network_partition, 240, 30, 0);
  add(network_drop, 250, 60, 2).magnitudes = {0.5};
  add(process_kill, 320, 600, 4);
  write_scenario();
  std::vector<TickRecord> day;
  const auto keep = [&](const TickRecord& record) { day.push_back(record); };
  const std::string alone = digest_over_dds(1, keep);
  EXPECT_EQ(alone, digest_in_process());
  EXPECT_EQ(writers_of(day, 0).size(), 1U);
  EXPECT_EQ(writers_of(day, 1).size(), 2U) << "killed, and started again";
  EXPECT_EQ(writers_of(day, 3).size(), 1U) << "stood still";
  EXPECT_EQ(writers_of(day, 4).size(), 2U);
  for (const auto& record : day) {
    EXPECT_TRUE(record.exchange.incidents.empty()) << record.exchange.incidents.front().what;
  }
  EXPECT_EQ(digest_over_dds(2), digest_in_process(2));
}

}  // namespace
}  // namespace evbal
