#include "experiments/study/executors/play_days.hpp"

#include "experiments/metrics/day_result.hpp"
#include "experiments/study/store/sweep_file.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <map>

namespace evbal {
namespace {

class DaysAtWork : public ::testing::Test {
 protected:
  DaysAtWork() {
    for (const std::string day : {"2024-01-11", "2024-01-12", "2024-01-13"}) {
      sweep_.days.push_back(
          {.variant = "v", .faults = {}, .day = day, .seed = 1, .yaml = YamlValue::parse("{}", "toy")});
    }
  }

  /// Does all days, of which each fails as often as `failures_` says.
  std::vector<FailedDay> do_all() {
    const auto work = [this](const std::vector<std::size_t>& days, const Done& done) {
      calls_.push_back(days);
      for (const std::size_t i : days) {
        if (failures_[i]-- > 0) {
          done(i, "reason " + std::to_string(failures_[i]));
        } else {
          add_result(file_, keys_[i], {}, {});
          done(i, "");
        }
      }
    };
    return do_days(
        sweep_, keys_, file_, [this](const DayEnded& day) { told_.push_back(day); }, work);
  }

  Folder folder_;
  std::filesystem::path file_ = folder_.path() / "sweep.sqlite";
  Sweep sweep_;
  std::vector<std::string> keys_ = {"a", "b", "c"};
  std::map<std::size_t, int> failures_;
  std::vector<std::vector<std::size_t>> calls_;
  std::vector<DayEnded> told_;
};

TEST_F(DaysAtWork, AreTriedOnceMoreIfTheyFail) {
  failures_ = {{0, 2}, {1, 1}};
  const std::vector<FailedDay> failed = do_all();
  EXPECT_EQ(calls_, (std::vector<std::vector<std::size_t>>{{0, 1, 2}, {0, 1}}));
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_EQ(failed[0].day, "v 2024-01-11 seed 1");
  EXPECT_EQ(failed[0].reason, "reason 0");
  EXPECT_EQ(shown(failed), "\n  v 2024-01-11 seed 1: reason 0");
  EXPECT_EQ(failures_in(file_), (std::map<std::string, std::string>{{"a", "reason 0"}}));
  ASSERT_EQ(told_.size(), 5U);
  EXPECT_TRUE(told_[0].failed && told_[0].again);
  EXPECT_EQ(told_[2].ended, 1U);
  EXPECT_TRUE(told_[3].failed && !told_[3].again);
  EXPECT_EQ(told_[4].ended, 3U);
}

TEST_F(DaysAtWork, ThatFailedAreTriedByTheNextStart) {
  failures_ = {{0, 2}};
  EXPECT_EQ(do_all().size(), 1U);
  EXPECT_TRUE(do_all().empty());
  EXPECT_EQ(calls_.back(), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(failures_in(file_).empty());
  calls_.clear();
  EXPECT_TRUE(do_all().empty());
  EXPECT_EQ(calls_, (std::vector<std::vector<std::size_t>>{{}}));
}

TEST_F(DaysAtWork, OfWhichManyFailAreNotAllNamed) {
  const std::vector<FailedDay> many(25, FailedDay{"a day", "why"});
  EXPECT_NE(shown(many).find("\n  and 5 more"), std::string::npos) << shown(many);
}

}  // namespace
}  // namespace evbal
