#include "tools/evbal/console_table.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(ConsoleTable, SaysThatARecoveryWasNotSeen) {
  const std::string table = cost_table({{"lost", {.with = 3.0, .without = 1.0}}, {"served", {.recovered = 30}}});
  EXPECT_NE(table.find("not seen before the day ended\n"), std::string::npos) << table;
  EXPECT_NE(table.find("30 min\n"), std::string::npos) << table;
  EXPECT_EQ(table.find("never"), std::string::npos) << table;
}

}  // namespace
}  // namespace evbal
