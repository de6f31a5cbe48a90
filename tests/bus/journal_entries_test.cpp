#include "agents/bus/journal_entries.hpp"

#include "agents/protocol/fingerprint.hpp"
#include "agents/region/region_plant.hpp"
#include "common/journal.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/conductor/run_day.hpp"
#include "tests/folder.hpp"
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

/// What each region is told in a day in which a plan moves cars at random.
std::vector<AgentEntry> told_in_a_day(const World& world, const std::vector<Faults>& faults) {
  InprocPlayers players(
      world, [](int tick, const auto& reports) { return test::wander(7, tick, reports); },
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

// The journal of a region is cut at any byte, as when its process dies while it writes; the entries that are lost were
// not answered either.
RC_GTEST_PROP(JournalEntries, LetARegionGoOnFromAnyByte, ()) {
  const World world = *test::small_worlds();
  const auto told = told_in_a_day(world, *test::faults_for(world));
  const int region = *rc::gen::inRange(0, world.city.size());
  const Folder folder;
  const std::filesystem::path file = folder.path() / "journal";
  std::vector<std::string> answers;
  {
    Journal journal(file);
    RegionPlant plant = make_plant(world, region);
    for (const auto& entry : told) {
      const AgentEntry own{.tick = for_regions(entry.tick, region, region), .plan = {}};
      journal.append(to_bytes(own));
      answers.push_back(answer(plant, own));
    }
  }
  std::filesystem::resize_file(file, *rc::gen::inRange<std::uintmax_t>(0, std::filesystem::file_size(file) + 1));
  RegionPlant plant = make_plant(world, region);
  const Journal journal(file);
  std::size_t tick = 0;
  for (const auto& entry : journal.entries()) {
    RC_ASSERT(answer(plant, from_bytes<AgentEntry>(entry)) == answers[tick++]);
  }
  for (; tick < told.size(); ++tick) {
    const AgentEntry own{.tick = for_regions(told[tick].tick, region, region), .plan = {}};
    RC_ASSERT(answer(plant, own) == answers[tick]);
  }
}

// A region says the same to its share of a tick and of a plan as to the whole.
RC_GTEST_PROP(JournalEntries, HoldAllThatConcernsARegion, ()) {
  const World world = *test::small_worlds();
  const int region = *rc::gen::inRange(0, world.city.size());
  RegionPlant plant = make_plant(world, region);
  RegionPlant again = make_plant(world, region);
  for (const auto& entry : told_in_a_day(world, *test::faults_for(world))) {
    AgentEntry share{.tick = for_regions(entry.tick, region, region), .plan = {}};
    for (const auto& plan : entry.plan) {
      share.plan.push_back(for_regions(plan, region, region));
    }
    RC_ASSERT(answer(plant, entry) == answer(again, from_bytes<AgentEntry>(to_bytes(share))));
  }
}

TEST(JournalEntries, GiveTheCoordinatorItsPlanBack) {
  const CoordinatorEntry entry{
      .tick = 4,
      .reports = {{.tick = 4, .region = 1, .plugged_since = {3, 4}, .bound = {}, .origin = {}}},
      .plan = {.tick = 4,
               .moves = {{.from = 1, .to = 2, .count = 3}},
               .provenance = {},
               .origin = {.process_id = 12, .seconds = 0.5}},
      .memory = std::string("a\0b", 3)};
  const auto back = from_bytes<CoordinatorEntry>(to_bytes(entry));
  EXPECT_EQ(to_bytes(back), to_bytes(entry));
  EXPECT_EQ(back.memory, entry.memory);
  EXPECT_EQ(back.plan.origin.process_id, 12);
  EXPECT_EQ(back.reports.at(0).plugged_since, entry.reports.at(0).plugged_since);
}

TEST(JournalEntries, AreReadToTheLastByte) {
  const std::string bytes = to_bytes(
      AgentEntry{.tick = {.tick = 3, .due = {1, 2}, .arrivals = {}, .under_way = {}, .effects = {}}, .plan = {Plan{}}});
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(from_bytes<AgentEntry>(bytes.substr(0, size)), Error) << size;
  }
  EXPECT_THROW(from_bytes<AgentEntry>(bytes + "x"), Error);
}

}  // namespace
}  // namespace evbal
