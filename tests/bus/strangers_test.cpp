#include "agents/bus/strangers.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

using namespace std::chrono_literals;

const BusAddress secured{.run = "1-2", .participants = 5, .keys = "keys/conductor"};

/// A participant that says it is a process of the run.
GuidPrefix prefix(const std::string& process, std::uint8_t last = 0) {
  const SubjectHash subject = hash_of({.run = "1-2", .process = process});
  GuidPrefix prefix{};
  std::ranges::copy(subject, prefix.begin());
  prefix.back() = last;
  return prefix;
}

TEST(Roster, KnowsProcessesByTheirCertificates) {
  const Roster roster(secured);
  EXPECT_EQ(roster.number_of(prefix("conductor")), BusAddress::conductor);
  EXPECT_EQ(roster.number_of(prefix("agent-1", 7)), BusAddress::first_agent + 1);
  EXPECT_EQ(roster.number_of(prefix("agent-2")), -1) << "there are two";
  GuidPrefix says_so{};
  says_so[8] = BusAddress::coordinator;
  EXPECT_EQ(roster.number_of(says_so), -1);
}

TEST(Roster, BelievesWhatIsSaidWithoutSecurity) {
  const Roster roster({.run = "1-2", .participants = 5});
  GuidPrefix says_so{};
  says_so[8] = 4;
  EXPECT_EQ(roster.number_of(says_so), 4);
  says_so[8] = 5;
  EXPECT_EQ(roster.number_of(says_so), -1);
}

class StrangersAccount : public testing::Test {
 protected:
  Roster roster_{secured};
  Strangers strangers_{roster_};
  Strangers::Clock::time_point now_{};
};

TEST_F(StrangersAccount, LeavesOutWhoProvesItself) {
  strangers_.seen(prefix("agent-1"), "agent-1", now_);
  strangers_.proved(prefix("agent-1"));
  EXPECT_TRUE(strangers_.named(now_ + 1h).empty());
}

TEST_F(StrangersAccount, NamesOnceWhoHasNoCertificateOfTheRun) {
  strangers_.seen(GuidPrefix{0xab}, "a\n`b", now_);
  EXPECT_EQ(strangers_.named(now_),
            (std::vector<std::string>{"participant ab0000000000000000000000, which calls itself `a??b`, has no "
                                      "certificate of this run"}));
  EXPECT_TRUE(strangers_.named(now_ + 1h).empty());
}

TEST_F(StrangersAccount, NamesWhoFailsAndWhoDoesNotTry) {
  strangers_.seen(prefix("agent-1"), "x", now_);
  strangers_.failed(prefix("agent-1"));
  strangers_.seen(prefix("agent-0"), "y", now_);
  auto named = strangers_.named(now_);
  ASSERT_EQ(named.size(), 1U);
  EXPECT_NE(named[0].find("`x`, cannot prove that it is agent-1"), std::string::npos);
  named = strangers_.named(now_ + Strangers::time_to_prove);
  ASSERT_EQ(named.size(), 1U);
  EXPECT_NE(named[0].find("`y`, has not proved that it is agent-0"), std::string::npos);
}

TEST_F(StrangersAccount, DoesNotDependOnWhetherProofComesBeforeSight) {
  strangers_.proved(prefix("agent-1"));
  strangers_.seen(prefix("agent-1"), "agent-1", now_);
  strangers_.failed(prefix("agent-0"), now_);
  strangers_.seen(prefix("agent-0"), "x", now_);
  const auto named = strangers_.named(now_ + 1h);
  ASSERT_EQ(named.size(), 1U);
  EXPECT_TRUE(named[0].ends_with("0000 cannot prove that it is agent-0")) << named[0];
}

TEST_F(StrangersAccount, IsShortHoweverManyCome) {
  for (int i = 0; i < 1000; ++i) {
    GuidPrefix who{};
    who[1] = static_cast<std::uint8_t>(i / 256);
    who[2] = static_cast<std::uint8_t>(i % 256);
    strangers_.seen(who, "z", now_);
  }
  const auto named = strangers_.named(now_);
  EXPECT_EQ(named.size(), Strangers::most_named + 1);
  EXPECT_EQ(named.back(), "900 more");
}

TEST(Strangers, AreNoneWithoutSecurity) {
  const Roster roster({.run = "1-2", .participants = 5});
  Strangers strangers(roster);
  strangers.seen(GuidPrefix{0xab}, "x");
  EXPECT_TRUE(strangers.named().empty());
}

}  // namespace
}  // namespace evbal
