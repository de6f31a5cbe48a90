#include "experiments/record/paired_run.hpp"

#include "common/error.hpp"
#include "experiments/record/compare.hpp"
#include "tests/folder.hpp"
#include "tests/record/small_day.hpp"
#include "tests/support/full_disk.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

RecordedRun recorded(const std::filesystem::path& folder, const RunHeader& header, const std::vector<TickRecord>& day) {
  RunRecord record(folder, header);
  for (const auto& tick : day) {
    record.add(tick);
  }
  mark_complete(record.finish({}).folder);
  return read_run(folder);
}

/// The small day, in which nobody is lost after the outage, and the same with the loss, in a directory below.
class PairedRun : public ::testing::Test {
 protected:
  PairedRun() {
    auto day = small_day();
    day[3].exchange.departures[0].fates[0].served = true;
    auto header = small_header();
    header.faults = {{.name = "jam", .type = "travel.slow", .start = 0, .end = 5}};
    twin_ = recorded(twin_folder(run_folder()), small_header(), small_day());
    run_ = recorded(run_folder(), header, day);
  }

  std::filesystem::path run_folder() const { return folder_.path() / "run"; }

  Folder folder_;
  RecordedRun run_;
  RecordedRun twin_;
};

TEST_F(PairedRun, SaysWhatTheFaultsCost) {
  const auto costs = costs_of(run_, twin_);
  const auto lost = std::ranges::find(costs, "lost", &MetricCost::metric);
  ASSERT_NE(lost, costs.end());
  EXPECT_EQ(lost->cost.with, 1.0);
  EXPECT_EQ(lost->cost.without, 2.0);
  EXPECT_DOUBLE_EQ(lost->cost.area, 10.0 / 60.0);
  EXPECT_EQ(lost->cost.recovered, std::nullopt);
  EXPECT_EQ(lost->cost.by_fault, (std::vector<std::optional<int>>{std::nullopt}));
}

TEST_F(PairedRun, WritesItDown) {
  write_costs(run_, twin_, costs_of(run_, twin_));
  const std::string csv = text_of(run_folder() / "faults.csv");
  EXPECT_TRUE(csv.starts_with("metric,with,without,cost,area,signed_area,band,recovered_min,recovered_min:jam\n"));
  EXPECT_NE(csv.find("\nidle_km,5,5,0,0,0,1,0,0\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",0.25,,\n"), std::string::npos) << "lost never came back:\n" << csv;
  const std::string summary = text_of(run_folder() / "summary.json");
  EXPECT_NE(summary.find("\"without_faults\""), std::string::npos) << summary;
  EXPECT_NE(summary.find("\"jam\": null"), std::string::npos) << summary;
  EXPECT_EQ(read_run(run_folder()).totals, run_.totals);
}

TEST_F(PairedRun, KeepsTheSummaryIfTheDiskIsFull) {
  const std::string before = text_of(run_folder() / "summary.json");
  {
    const FullDisk full(256);
    try {
      write_costs(run_, twin_, costs_of(run_, twin_));
      FAIL() << "was written";
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::run_failed);
      EXPECT_NE(std::string(error.what()).find("faults.csv: cannot be written: File too large"), std::string::npos)
          << error.what();
    }
  }
  EXPECT_EQ(text_of(run_folder() / "summary.json"), before);
  EXPECT_FALSE(std::filesystem::exists(run_folder() / "faults.csv"));
  {
    const FullDisk full(1000);  // enough for faults.csv, not for summary.json
    EXPECT_THROW(write_costs(run_, twin_, costs_of(run_, twin_)), Error);
  }
  EXPECT_EQ(text_of(run_folder() / "summary.json"), before);
}

TEST_F(PairedRun, QuotesNamesInItsTable) {
  run_.faults[0].name = "a \"jam\", west";
  write_costs(run_, twin_, costs_of(run_, twin_));
  const std::string csv = text_of(run_folder() / "faults.csv");
  EXPECT_NE(csv.find(",\"recovered_min:a \"\"jam\"\", west\"\n"), std::string::npos) << csv;
}

TEST_F(PairedRun, IsNoDifferenceToAReplay) {
  const auto header = small_header();
  recorded(folder_.path() / "again", header, small_day());
  write_costs(twin_, run_, costs_of(twin_, run_));
  EXPECT_EQ(first_difference(twin_.folder, folder_.path() / "again", header.frame.clock), std::nullopt);
}

}  // namespace
}  // namespace evbal
