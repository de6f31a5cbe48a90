#include "experiments/record/recorded_run.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tests/record/small_day.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(RecordedRun, GivesRegionsAndFaultsBack) {
  const Folder folder;
  const auto run_folder = folder.path() / "run";
  EXPECT_THROW(read_run(run_folder), Error);
  RunRecord record(run_folder, small_header());
  for (const auto& tick : small_day()) {
    record.add(tick);
  }
  record.finish();
  const RecordedRun run = read_run(run_folder);
  EXPECT_EQ(run.ticks, 4);
  EXPECT_EQ(run.by_region.at("demand"), (Eigen::MatrixXd(2, 2) << 4, 0, 1, 0).finished());
  ASSERT_EQ(run.faults.size(), 1U);
  const RecordedFault& outage = run.faults[0];
  EXPECT_EQ(outage.name, "outage");
  EXPECT_EQ(outage.end, 15);
  EXPECT_EQ(outage.said, (std::map<int, std::set<int>>{{2, {1}}}));
  EXPECT_EQ(outage.amount, (std::map<int, double>{{2, 1.0}}));
  EXPECT_EQ(outage.seen_regions, std::set<int>{1});
  EXPECT_EQ(outage.evicted, 0);
}

}  // namespace
}  // namespace evbal
