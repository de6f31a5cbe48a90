#include "agents/hosting/journal_entries.hpp"

#include "agents/bus/cdr.hpp"
#include "agents/protocol/fingerprint.hpp"
#include "agents/region/region_plant.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/conductor/run_day.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace evbal {
namespace {

/// What a region says to an entry, as one digest.
std::string answer(RegionPlant& plant, const AgentEntry& told) {
  Digest digest;
  plant.begin(told.tick);
  if (told.tick.plan_due) {
    fingerprint(digest, plant.report());
  }
  fingerprint(digest, plant.live(told.plan.empty() ? nullptr : &told.plan.front()));
  return digest.hex();
}

/// What comes over the bus to the agent of a region alone.
template <class Message>
Message heard_by(int region, const Message& message) {
  const Sample<Message> sample{.run = "r", .message = message};
  std::string bytes(cdr_size(sample), '\0');
  write_cdr(sample, bytes.data());
  return read_cdr<Message>(bytes, {region, region}).message;
}

/// What all regions are told in a day in which a plan moves cars at random.
std::vector<AgentEntry> told_in_a_day(const World& world, const std::vector<Faults>& faults) {
  InprocPlayers players(
      world, [](const Tick& tick, const auto& reports) { return test::wander(7, tick.tick, reports); },
      [&](int tick) { return faults[tick]; });
  std::vector<AgentEntry> told;
  run_day(world, players, [&](const TickRecord& record) {
    told.push_back({.tick = record.tick, .plan = {}});
    if (record.exchange.plan) {
      told.back().plan.push_back(*record.exchange.plan);
    }
  });
  return told;
}

// What a region answers to its share of what was said, written down and read back, is what it answers to the whole.
RC_GTEST_PROP(JournalEntries, HoldAllThatARegionAnswersTo, ()) {
  const World world = *test::small_worlds();
  const int region = *rc::gen::inRange(0, world.city.size());
  RegionPlant plant(region_worlds(world)[region]);
  RegionPlant again(region_worlds(world)[region]);
  for (const AgentEntry& told : told_in_a_day(world, *test::faults_for(world))) {
    AgentEntry share{.tick = heard_by(region, told.tick), .plan = {}};
    for (const auto& plan : told.plan) {
      share.plan.push_back(heard_by(region, plan));
    }
    RC_ASSERT(answer(plant, told) == answer(again, from_bytes<AgentEntry>(to_bytes(share))));
  }
}

TEST(JournalEntries, GiveTheCoordinatorItsPlanBack) {
  CoordinatorEntry entry;
  entry.tick.tick = 4;
  entry.reports.resize(2);
  entry.reports[1].plugged_since = {3, 4};
  entry.plan.moves = {{.from = 1, .to = 2, .count = 3}};
  entry.plan.origin.process_id = 12;
  entry.memory = std::string("a\0b", 3);
  const auto back = from_bytes<CoordinatorEntry>(to_bytes(entry));
  EXPECT_EQ(to_bytes(back), to_bytes(entry));
  EXPECT_EQ(back.memory, entry.memory);
  EXPECT_EQ(back.plan.origin.process_id, 12);
  EXPECT_EQ(back.reports.at(1).plugged_since, entry.reports[1].plugged_since);
}

TEST(JournalEntries, AreReadToTheLastByte) {
  AgentEntry entry;
  entry.tick.due = {1, 2};
  entry.plan.resize(1);
  const std::string bytes = to_bytes(entry);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(from_bytes<AgentEntry>(bytes.substr(0, size)), Error) << size;
  }
  EXPECT_THROW(from_bytes<AgentEntry>(bytes + "x"), Error);
}

}  // namespace
}  // namespace evbal
