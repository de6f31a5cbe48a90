#include "tools/records/local_clock.hpp"

#include "common/error.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

LocalClock clock_of(const std::string& yaml) {
  YamlMap map(YamlValue::parse(yaml, "format.yaml"));
  return read_local_clock(map);
}

/// California in 2008.
LocalClock california() {
  return clock_of(
      "utc_offset_minutes: -480\n"
      "clock_changes:\n"
      "  - {utc: \"2008-03-09 10:00:00\", utc_offset_minutes: -420}\n"
      "  - {utc: \"2008-11-02 09:00:00\", utc_offset_minutes: -480}\n");
}

long long at(const std::string& text) {
  return parse_time(text).value();
}

TEST(ParseTime, ReadsDateAndTimeOfDay) {
  EXPECT_EQ(at("1970-01-01 00:00:00"), 0);
  EXPECT_EQ(at("2008-05-18T07:31:05"), 1'211'095'865);
  for (const char* text :
       {"", "2008-05-18", "2008-5-18 07:31:05", "2008-02-30 07:31:05", "2008-05-18 24:00:00", "2008-05-18 07:31:60",
        "2008-05-18 07:31:05Z", "2008-05-18 07-31-05", "2008-05-18 0x:31:05"}) {
    EXPECT_FALSE(parse_time(text)) << text;
  }
}

TEST(LocalClock, FollowsDaylightSaving) {
  const LocalClock clock = california();
  EXPECT_EQ(clock.local(at("2008-01-01 12:00:00")), at("2008-01-01 04:00:00"));
  EXPECT_EQ(clock.local(at("2008-03-09 09:59:59")), at("2008-03-09 01:59:59"));
  EXPECT_EQ(clock.local(at("2008-03-09 10:00:00")), at("2008-03-09 03:00:00"));
  EXPECT_EQ(clock.local(at("2008-12-01 12:00:00")), at("2008-12-01 04:00:00"));
}

TEST(LocalClock, KnowsHoursThatAreSkippedOrComeTwice) {
  const LocalClock clock = california();
  EXPECT_EQ(clock.utc(at("2008-06-01 12:00:00")), std::vector<long long>{at("2008-06-01 19:00:00")});
  EXPECT_TRUE(clock.utc(at("2008-03-09 02:30:00")).empty());
  EXPECT_EQ(clock.utc(at("2008-03-09 03:00:00")), std::vector<long long>{at("2008-03-09 10:00:00")});
  EXPECT_EQ(clock.utc(at("2008-11-02 01:30:00")),
            (std::vector<long long>{at("2008-11-02 08:30:00"), at("2008-11-02 09:30:00")}));
  EXPECT_EQ(LocalClock(480).utc(at("2019-01-01 08:00:00")), std::vector<long long>{at("2019-01-01 00:00:00")});
}

TEST(LocalClock, RefusesWhatIsNoClock) {
  EXPECT_THROW(clock_of("utc_offset_minutes: -4200\n"), Error);
  EXPECT_THROW(clock_of("utc_offset_minutes: 0\nclock_changes: [{utc: \"tomorrow\", utc_offset_minutes: 60}]\n"),
               Error);
  EXPECT_THROW(clock_of("utc_offset_minutes: 0\nclock_changes:\n"
                        "  - {utc: \"2008-11-02 09:00:00\", utc_offset_minutes: 60}\n"
                        "  - {utc: \"2008-03-09 10:00:00\", utc_offset_minutes: 0}\n"),
               Error);
}

}  // namespace
}  // namespace evbal
