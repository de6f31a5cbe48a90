#include "common/log.hpp"

#include "common/error.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

class LogTest : public testing::Test {
 protected:
  ~LogTest() override { begin_log("evbal", LogLevel::warn); }

  static std::string written(LogLevel least) {
    begin_log("agent-3", least);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    log_line(LogLevel::debug, "a detail");
    log_line(LogLevel::info, "a step");
    log_line(LogLevel::warn, "a worry");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    return testing::internal::GetCapturedStderr();
  }
};

TEST_F(LogTest, WritesWhatMattersEnoughToStderr) {
  const std::string all = written(LogLevel::debug);
  EXPECT_NE(all.find(" debug agent-3: a detail\n"), std::string::npos) << all;
  EXPECT_NE(all.find(" info agent-3: a step\n"), std::string::npos) << all;
  const std::string worries = written(LogLevel::warn);
  EXPECT_EQ(worries.find("a step"), std::string::npos) << worries;
  EXPECT_NE(worries.find(" warn agent-3: a worry\n"), std::string::npos) << worries;
  EXPECT_EQ(written(LogLevel::error), "");
}

TEST_F(LogTest, KnowsItsLevelsByName) {
  for (std::size_t level = 0; level < log_levels().size(); ++level) {
    begin_log("evbal", log_level_of(log_levels()[level]));
    EXPECT_EQ(least_logged(), static_cast<LogLevel>(level));
  }
  EXPECT_THROW(log_level_of("loud"), Error);
}

}  // namespace
}  // namespace evbal
