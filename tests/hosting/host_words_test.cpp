#include "agents/hosting/host_words.hpp"

#include "agents/hosting/journal.hpp"
#include "agents/hosting/journal_entries.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

HostOrder start_order() {
  return {.kind = HostOrderKind::start,
          .process = "agent-3",
          .words = {"--name", "agent-3"},
          .files = {{"agent-3.world", std::string("\0\n12\n", 5)}}};
}

TEST(HostWords, ComeThroughInPieces) {
  const std::string bytes = "welcome to b\n" + std::string(keeper_greeting) + frame(HostOrder{}) + frame(start_order());
  FrameReader reader;
  bool greeted = false;
  std::vector<HostOrder> orders;
  for (const char byte : bytes) {
    reader.add({&byte, 1});
    greeted = greeted || reader.greeted();
    while (const auto order = greeted ? reader.next<HostOrder>() : std::nullopt) {
      orders.push_back(*order);
    }
  }
  ASSERT_EQ(orders.size(), 2U);
  EXPECT_EQ(orders[0].kind, HostOrderKind::alive);
  EXPECT_EQ(to_bytes(orders[1]), to_bytes(start_order()));
}

TEST(HostWords, AreRefusedIfTheyAreNone) {
  for (const std::string bytes :
       {"hello, how are you\n", "-3\nabc\n", "3\nabc\n", "99999999999\n", "1234567890123456"}) {
    FrameReader reader;
    reader.add(bytes);
    EXPECT_THROW(reader.next<HostNews>(), Error) << bytes;
  }
  FrameReader reader;
  reader.add(std::string(2'000'000, 'x'));
  EXPECT_THROW(reader.greeted(), Error) << "a host that talks of something else";
}

TEST(AgentEntry, IsWhatTheAgentItselfJournals) {
  Tick tick;
  tick.tick = 6;
  tick.plan_due = true;
  tick.due = {0, 1, 2};
  tick.arrivals.resize(3);
  tick.arrivals[1].region = 1;
  tick.arrivals[2].region = 2;
  Plan plan;
  plan.tick = 6;
  plan.moves.resize(2);
  plan.moves[1].from = 1;
  const AgentEntry entry = agent_entry(tick, &plan, {1, 2});
  EXPECT_EQ(entry.tick.due, tick.due);
  ASSERT_EQ(entry.tick.arrivals.size(), 2U);
  EXPECT_EQ(entry.tick.arrivals.front().region, 1);
  ASSERT_EQ(entry.plan.size(), 1U);
  ASSERT_EQ(entry.plan.front().moves.size(), 1U);
  EXPECT_EQ(entry.plan.front().moves.front().from, 1);

  tick.unplanned = {1, 2};
  EXPECT_TRUE(agent_entry(tick, &plan, {1, 2}).plan.empty());
  EXPECT_EQ(agent_entry(tick, &plan, {0, 0}).plan.size(), 1U);
  tick.unattended = true;
  EXPECT_TRUE(agent_entry(tick, &plan, {0, 0}).plan.empty());
}

TEST(Journal, IsTheTextOfItsEntries) {
  const Folder folder;
  Journal journal(folder.path() / "journal");
  journal.append("one");
  journal.append(std::string("\0two", 4));
  EXPECT_EQ(text_of(folder.path() / "journal"), journal_text("one") + journal_text(std::string("\0two", 4)));
}

}  // namespace
}  // namespace evbal
