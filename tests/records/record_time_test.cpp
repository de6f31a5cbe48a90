#include "tools/records/record_time.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(ParseUnixSeconds, TakesWhatProgramsWrite) {
  EXPECT_EQ(parse_unix_seconds("1211137200"), 1'211'137'200);
  EXPECT_EQ(parse_unix_seconds("1211137200.0"), 1'211'137'200);
  EXPECT_EQ(parse_unix_seconds("1.2111372e+09"), 1'211'137'200);
  for (const char* none : {"", "-1", "1211137200000", "1211137200.5", "07:31", "nan"}) {
    EXPECT_FALSE(parse_unix_seconds(none)) << none;
  }
}

}  // namespace
}  // namespace evbal
