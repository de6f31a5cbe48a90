#include "common/error.hpp"
#include "experiments/record/compare.hpp"
#include "experiments/record/run_record.hpp"
#include "tests/folder.hpp"
#include "tests/record/small_day.hpp"
#include "tests/support/full_disk.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;

class Record : public ::testing::Test {
 protected:
  RunResult written(const std::string& name, const std::vector<TickRecord>& day = small_day()) const {
    RunRecord record(folder_ / name, small_header());
    for (const auto& tick : day) {
      record.add(tick);
    }
    return record.finish({});
  }

  std::optional<std::string> difference() const {
    return first_difference(folder_ / "a", folder_ / "b", small_clock());
  }

  void replace(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = text_of(folder_ / file);
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from << " is not in\n" << text;
    std::ofstream(folder_ / file) << text.replace(at, from.size(), to);
  }

  Folder own_;
  fs::path folder_ = own_.path() / "runs";
};

TEST_F(Record, IsCompleteWhenFinished) {
  const RunResult result = written("a");
  for (const char* file : {"scenario.resolved.yaml", "summary.json", "steps.csv", "regions.csv", "run.sqlite"}) {
    EXPECT_TRUE(fs::exists(folder_ / "a" / file)) << file;
  }
  EXPECT_EQ(text_of(folder_ / "a" / "INCOMPLETE"), "recorded 4 of 4 ticks, until 05:20\n");
  mark_complete(result.folder);
  EXPECT_FALSE(fs::exists(folder_ / "a" / "INCOMPLETE"));
  EXPECT_EQ(text_of(folder_ / "a" / "scenario.resolved.yaml"), "seed: 7\n");
  EXPECT_EQ(result.totals.flows.served, 1);
  const std::string summary = text_of(folder_ / "a" / "summary.json");
  EXPECT_NE(summary.find("\"digest\": \"" + result.digest + "\""), std::string::npos) << summary;
  EXPECT_NE(summary.find("\"fleet\": 6"), std::string::npos) << summary;
  EXPECT_NE(summary.find("\"solves\": 2"), std::string::npos) << summary;
}

TEST_F(Record, RefusesADirectoryThatIsNotEmpty) {
  fs::create_directories(folder_ / "a");
  std::ofstream(folder_ / "a" / "mine.txt") << "dear to me";
  try {
    written("a");
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "a"), {}), 1);
}

TEST_F(Record, LeavesNothingIfNothingHappened) {
  fs::create_directories(folder_);
  { const RunRecord record(folder_ / "a", small_header()); }
  EXPECT_FALSE(fs::exists(folder_ / "a"));
}

TEST_F(Record, IsMarkedIfItBreaksOff) {
  {
    RunRecord record(folder_ / "a", small_header());
    record.add(small_day()[0]);
  }
  EXPECT_EQ(text_of(folder_ / "a" / "INCOMPLETE"), "recorded 1 of 4 ticks, until 05:05\n");
  EXPECT_FALSE(fs::exists(folder_ / "a" / "summary.json"));
}

TEST_F(Record, SaysWhyItCannotGoOnIfTheDiskIsFull) {
  RunRecord record(folder_ / "a", small_header());
  const FullDisk full(100);
  try {
    for (const auto& tick : small_day()) {
      record.add(tick);
    }
    record.finish({});
    FAIL() << "was recorded";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::run_failed);
    EXPECT_NE(std::string(error.what()).find("run.sqlite: cannot be written: "), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("File too large"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(record.break_off("the disk is full"));
  EXPECT_TRUE(fs::exists(folder_ / "a" / "INCOMPLETE"));
}

TEST_F(Record, DigestKnowsWhatWasSaidAndNotByWhom) {
  auto day = small_day();
  const std::string digest = digest_of(day);
  EXPECT_EQ(digest, written("a").digest);
  day[1].exchange.departures[0].origin = {.process_id = 77, .seconds = 3.0};
  day[2].exchange.plan->origin.process_id = 78;
  day[2].exchange.plan->provenance.costs = {{.term = "km", .cost = 3.0}};
  EXPECT_EQ(digest_of(day), digest);
  day[3].exchange.departures[0].fates[0].waited = 12;
  EXPECT_NE(digest_of(day), digest);
}

TEST_F(Record, TwoRunsOfTheSameDayAreEqual) {
  auto day = small_day();
  written("a", day);
  day[2].exchange.plan->origin = {.process_id = 99, .seconds = 1.5};
  written("b", day);
  EXPECT_EQ(difference(), std::nullopt);
}

TEST_F(Record, NamesTheFirstDifferenceOfTwoDays) {
  written("a");
  auto day = small_day();
  day[3].exchange.departures[0].fates[0].waited = 12;
  day[2].exchange.departures[1].departures[0].km = 2.5;
  written("b", day);
  EXPECT_EQ(difference(), "run.sqlite: vehicles, tick 2, region 1: km is `2`, the replay gives `2.5`");
}

TEST_F(Record, NamesAnAlteredCell) {
  written("a");
  written("b");
  replace("a/steps.csv", "05:10,1,1,", "05:10,1,9,");
  EXPECT_EQ(difference(), "steps.csv: step 1 (tick 2): idle_km is `9`, the replay gives `1`");
  fs::copy_file(folder_ / "b" / "steps.csv", folder_ / "a" / "steps.csv", fs::copy_options::overwrite_existing);
  replace("a/regions.csv", "05:00,0,1,1,", "05:00,0,1,3,");
  EXPECT_EQ(difference(), "regions.csv: step 0 (tick 0), region 1: demand is `3`, the replay gives `1`");
  fs::copy_file(folder_ / "b" / "regions.csv", folder_ / "a" / "regions.csv", fs::copy_options::overwrite_existing);
  replace("a/summary.json", "\"lost\": 2", "\"lost\": 1");
  EXPECT_EQ(difference(), "summary.json: totals/lost is 1, the replay gives 2");
}

TEST_F(Record, SeesMissingLinesAndFiles) {
  written("a");
  written("b");
  std::string text = text_of(folder_ / "b" / "regions.csv");
  text.erase(text.rfind('\n', text.size() - 2) + 1);
  std::ofstream(folder_ / "a" / "regions.csv") << text;
  EXPECT_TRUE(difference()->starts_with("regions.csv: step 1 (tick 2), region 1: ")) << *difference();
  fs::remove(folder_ / "a" / "run.sqlite");
  EXPECT_TRUE(difference()->starts_with("run.sqlite: cannot be read")) << *difference();
}

TEST_F(Record, SeesAnAlteredScenario) {
  written("a");
  written("b");
  replace("a/summary.json", "\"scenario_digest\": \"", "\"scenario_digest\": \"0");
  EXPECT_TRUE(difference()->starts_with("scenario.resolved.yaml: ")) << *difference();
}

}  // namespace
}  // namespace evbal
