// What has come for a reader: it waits for as many messages as it needs, and for nobody's who has no say.

#include "agents/bus/participant.hpp"
#include "experiments/conductor/domain_lock.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <deque>
#include <set>

namespace evbal {
namespace {

using namespace std::chrono_literals;

constexpr auto patience = 1min;

/// A run of three agents of one region each, all of them in this process.
class InboxTest : public testing::Test {
 protected:
  InboxTest() {
    for (int participant = BusAddress::first_agent; participant < participants; ++participant) {
      agents_.emplace_back(at(participant), name_of(participant));
      writers_.emplace_back(agents_.back());
    }
  }

  BusAddress at(int participant) const {
    return {.run = "1-1", .domain = domain_.domain(), .participant = participant, .participants = participants};
  }

  void await_readers() {
    for (std::size_t i = 0; i < writers_.size(); ++i) {
      while (writers_[i].readers() == 0) {
        agents_[i].wait_for_match(patience);
      }
    }
  }

  static constexpr int participants = BusAddress::first_agent + 3;

  DomainLock domain_{participants};
  Participant conductor_{at(BusAddress::conductor), "conductor"};
  Reader<std::vector<Report>> reader_{conductor_};
  std::deque<Participant> agents_;
  std::deque<Writer<std::vector<Report>>> writers_;
};

std::vector<Report> report_of(int region) {
  Report report;
  report.region = region;
  return {report};
}

TEST_F(InboxTest, WaitsForAsManyAsAreNeeded) {
  await_readers();
  for (int agent = 0; agent < 3; ++agent) {
    writers_[agent].write(report_of(agent));
  }
  reader_.wait(patience, 3);
  std::set<int> regions;
  for (const auto& heard : reader_.take()) {
    regions.insert(heard.message.front().region);
  }
  EXPECT_EQ(regions, (std::set<int>{0, 1, 2}));
}

TEST_F(InboxTest, RefusesWhoSpeaksForAnotherThoughNobodyTakes) {
  await_readers();
  writers_[1].write(report_of(2));
  writers_[1].write(report_of(1));
  reader_.wait(patience);
  const auto refused = reader_.refused();
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused.begin()->first, "evbal/reports from agent-1, who speaks for another process");
  EXPECT_EQ(reader_.take().size(), 1U);
}

}  // namespace
}  // namespace evbal
