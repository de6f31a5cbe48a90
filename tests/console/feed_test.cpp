#include "tools/console/feed.hpp"

#include <gtest/gtest.h>

#include <string>

namespace evbal {
namespace {

using namespace std::chrono_literals;

std::string event_text(const std::string& kind, const std::string& json) {
  return "event: " + kind + "\ndata: " + json + "\n\n";
}

TEST(Feed, TellsALateReaderTheWholeDay) {
  Feed feed;
  feed.begin_day("{}");
  feed.tell("tick", "1");
  feed.tell_state("a");
  feed.tell("tick", "2");
  Feed::Place place;
  EXPECT_EQ(feed.next(place, 0ms),
            event_text("day", "{}") + event_text("tick", "1") + event_text("tick", "2") + event_text("state", "a"));
  EXPECT_EQ(feed.next(place, 0ms), "");
}

TEST(Feed, OfStatesTellsTheNewestOnceOnly) {
  Feed feed;
  feed.begin_day("{}");
  Feed::Place place;
  feed.next(place, 0ms);
  feed.tell_state("a");
  feed.tell_state("b");
  EXPECT_EQ(feed.next(place, 0ms), event_text("state", "b"));
  feed.tell_state("b");
  EXPECT_EQ(feed.next(place, 0ms), "");
}

TEST(Feed, BeginsAnewWithTheNextDay) {
  Feed feed;
  feed.begin_day("1");
  feed.tell("tick", "1");
  Feed::Place place;
  feed.next(place, 0ms);
  feed.begin_day("2");
  EXPECT_EQ(feed.next(place, 0ms), event_text("day", "2"));
}

TEST(Feed, GivesMuchInPieces) {
  Feed feed;
  feed.begin_day("{}");
  for (int i = 0; i < 100; ++i) {
    feed.tell("tick", std::string(10'000, 'x'));
  }
  Feed::Place place;
  std::size_t all = 0;
  for (std::string text = feed.next(place, 0ms); !text.empty(); text = feed.next(place, 0ms)) {
    EXPECT_LT(text.size(), 100'000U);
    all += text.size();
  }
  EXPECT_GT(all, 1'000'000U);
}

TEST(Feed, IsOverForWhoHasHeardAll) {
  Feed feed;
  feed.begin_day("{}");
  Feed::Place place;
  feed.close();
  EXPECT_FALSE(feed.over(place));
  feed.next(place, 1h);
  EXPECT_TRUE(feed.over(place));
  EXPECT_EQ(feed.next(place, 1h), "") << "does not wait any more";
}

}  // namespace
}  // namespace evbal
