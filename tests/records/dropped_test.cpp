#include "tools/records/dropped.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(Dropped, CountsByReasonWithTheFirst) {
  Dropped dropped;
  EXPECT_EQ(dropped.report(), "");
  dropped.add("too short", "b.csv", 7, "12");
  dropped.add("no number", "a.csv", 9, "x");
  dropped.add("too short", "a.csv", 8, "13");
  EXPECT_EQ(dropped.rows(), 3);
  EXPECT_EQ(dropped.rows("too short"), 2);
  EXPECT_EQ(dropped.rows("too long"), 0);
  EXPECT_EQ(dropped.report(),
            "  dropped, no number: 1 (first: a.csv:9: `x`)\n"
            "  dropped, too short: 2 (first: b.csv:7: `12`)\n");
}

TEST(Dropped, ShowsAnyBytesAsALine) {
  Dropped dropped;
  dropped.add("no number", "a.csv", 1, "S\xFFtra\n\tx" + std::string(100, 'y'));
  EXPECT_EQ(dropped.report(), "  dropped, no number: 1 (first: a.csv:1: `S?tra??x" + std::string(52, 'y') + "...`)\n");
}

}  // namespace
}  // namespace evbal
