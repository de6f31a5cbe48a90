#include "tests/run/evbal/command_line.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// A finished run, which every test alters in one place.
class Replay : public ::testing::Test {
 protected:
  void SetUp() override {
    const Ended ended = line_.evbal("run morning.yaml --out a --quiet");
    ASSERT_EQ(ended.status, 0) << ended.err;
  }

  fs::path file(const std::string& name) const { return line_.path() / "a" / name; }

  void alter_text(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = text_of(file(name));
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::ofstream(file(name)) << text.replace(at, from.size(), to);
  }

  void alter_day(const std::string& statement) const {
    SQLite::Database database(file("run.sqlite").string(), SQLite::OPEN_READWRITE);
    ASSERT_EQ(database.exec(statement), 1) << statement;
  }

  /// The replay must end with 3 and a line that starts so and holds `also`.
  void expect_named(const std::string& start, const std::string& also = "") const {
    const Ended ended = line_.evbal("replay a --quiet");
    EXPECT_EQ(ended.status, 3);
    EXPECT_TRUE(ended.err.starts_with("evbal: " + start)) << ended.err;
    EXPECT_NE(ended.err.find(also), std::string::npos) << ended.err;
  }

  CommandLine line_;
};

TEST_F(Replay, LeavesAloneWhatHasANameThatOneMightGuess) {
  const fs::path place = line_.path() / "tmp";
  const std::string arguments = "replay a --quiet";
  const std::string script = "cd " + line_.path().string() + " && mkdir -p tmp/evbal-replay-$$ && " +
                             "echo dear >tmp/evbal-replay-$$/letter.txt && exec env TMPDIR=" + place.string() + " " +
                             EVBAL_PROGRAM + " " + arguments + " >out.txt 2>err.txt";
  EXPECT_EQ(std::system(script.c_str()), 0) << text_of(line_.path() / "err.txt");
  const auto left = fs::directory_iterator(place);
  ASSERT_NE(left, fs::directory_iterator());
  EXPECT_EQ(text_of(left->path() / "letter.txt"), "dear\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(place), {}), 1);
}

TEST_F(Replay, AgreesWithItsRun) {
  const Ended ended = line_.evbal("replay a --quiet");
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find(line_.summary("a", "digest").substr(1, 32)), std::string::npos) << ended.out;
}

TEST_F(Replay, AgreesWithARunOverDds) {
  ASSERT_EQ(line_.evbal("run morning.yaml --transport dds --out b --quiet").status, 0);
  const Ended ended = line_.evbal("replay b --quiet");
  EXPECT_EQ(ended.status, 0) << ended.err;
}

TEST_F(Replay, NamesTickAndRegionOfAnAlteredDay) {
  alter_day("UPDATE departures SET vacant = vacant + 1 WHERE tick = 17 AND region = 3");
  expect_named("run.sqlite: departures, tick 17, region 3: vacant is ");
}

TEST_F(Replay, SeesEveryTable) {
  for (const char* table : {"effects", "observed", "reports", "plans", "vehicles", "fates", "injector", "events"}) {
    const fs::path backup = line_.path() / "backup";
    fs::copy_file(file("run.sqlite"), backup, fs::copy_options::overwrite_existing);
    alter_day("DELETE FROM " + std::string(table) + " WHERE rowid = (SELECT max(rowid) FROM " + table + ")");
    expect_named("run.sqlite: " + std::string(table) + ", tick ", "a row is missing");
    fs::copy_file(backup, file("run.sqlite"), fs::copy_options::overwrite_existing);
  }
}

TEST_F(Replay, SeesAnAlteredPlan) {
  alter_day("UPDATE plans SET provenance_objective = provenance_objective + 1e-9 WHERE tick = 8");
  expect_named("run.sqlite: plans, tick 8, all regions: provenance_objective is ");
}

TEST_F(Replay, SeesAnAlteredTable) {
  alter_text("regions.csv", "\n07:30,1,2,", "\n07:30,1,2,9");
  expect_named("regions.csv: step 1 (tick 6), region 2: demand is ");
}

TEST_F(Replay, SeesAnAlteredStep) {
  alter_text("steps.csv", "\n09:00,4,", "\n09:00,4,1");
  expect_named("steps.csv: step 4 (tick 24): idle_km is ");
}

TEST_F(Replay, SeesAnAlteredTotal) {
  alter_text("summary.json", "\"served\": ", "\"served\": 1");
  expect_named("summary.json: totals/served is ");
}

TEST_F(Replay, SeesAnAlteredScenario) {
  alter_text("scenario.resolved.yaml", "seed: 1", "seed: 3");
  expect_named("run.sqlite: ", "tick 0, region ");
}

TEST_F(Replay, SeesAScenarioThatIsNoneAnyMore) {
  alter_text("scenario.resolved.yaml", "seed: 1", "sed: 1");
  expect_named("a/scenario.resolved.yaml:", "not what the run was made from");
}

TEST_F(Replay, RefusesWhatIsNoRun) {
  fs::remove(file("scenario.resolved.yaml"));
  EXPECT_EQ(line_.evbal("replay a --quiet").status, 2);
}

}  // namespace
}  // namespace evbal
