#include "experiments/study/store/sweep_file.hpp"

#include "common/error.hpp"
#include "experiments/study/store/finished_steps.hpp"
#include "experiments/study/store/sweep_origin.hpp"
#include "tests/folder.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>

namespace evbal {
namespace {

Sweep small_sweep() {
  const auto day = [](const std::string& variant, std::uint64_t seed, std::map<std::string, std::string> settings) {
    return SweptDay{.scenario = "toy",
                    .variant = variant,
                    .controller = "ratio",
                    .faults = "calm",
                    .day = "2024-01-11",
                    .seed = seed,
                    .settings = std::move(settings),
                    .yaml = YamlValue::parse("{}", "a.yaml")};
  };
  return {{"balancing.p_ratio", "x"},
          {day("a", 1, {{"balancing.p_ratio", "10"}}), day("a", 2, {{"balancing.p_ratio", "10"}}),
           day("b", 18446744073709551615ULL, {{"x", "[1, 2]"}})}};
}

DayResult small_result(int lost) {
  DayResult result;
  result.metrics.totals.flows.lost = lost;
  result.metrics.totals.idle_km = 0.1;
  result.metrics.steps = {{.step = 0, .idle_km = 1.0}, {.step = 1, .idle_km = 2.0}, {.step = 4, .idle_km = 0.5}};
  result.digest = "d" + std::to_string(lost);
  return result;
}

class SweepFileOf3 : public ::testing::Test {
 protected:
  void add(const std::string& key, int lost) const { add_result(file_, key, {}, small_result(lost)); }

  void note_origin_first() const {
    begin_results(file_);
    note_origin(file_, {.command = "c", .file = "a.yaml", .text = "t", .scenario = "s"});
  }

  Folder folder_;
  std::filesystem::path file_ = folder_.path() / "sweep.sqlite";
};

TEST_F(SweepFileOf3, ThatWasKilledBeforeItWroteAnythingGoesOn) {
  std::ofstream(file_).close();
  EXPECT_TRUE(played_by_others(file_, {"k1"}).empty());
  try {
    read_finished(file_);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("run the sweep first"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(begin_sweep(file_, small_sweep(), {"k1", "k2", "k3"}).empty());
  add("k1", 10);
  EXPECT_EQ(begin_sweep(file_, small_sweep(), {"k1", "k2", "k3"}), std::set<std::string>{"k1"});
}

TEST_F(SweepFileOf3, SaysTheSameInWhateverOrderDaysEnd) {
  EXPECT_TRUE(begin_sweep(file_, small_sweep(), {"k1", "k2", "k3"}).empty());
  add("k3", 30);
  EXPECT_EQ(begin_sweep(file_, small_sweep(), {"k1", "k2", "k3"}), (std::set<std::string>{"k3"}));
  EXPECT_THROW(read_finished(file_), Error);
  add("k1", 10);
  add("k2", 20);
  const std::string days = swept_days_csv(file_);
  EXPECT_TRUE(days.starts_with("run,scenario,variant,controller,faults,day,seed,balancing.p_ratio,x,idle_km,")) << days;
  EXPECT_NE(days.find("\n1,toy,a,ratio,calm,2024-01-11,1,10,,0.1,"), std::string::npos) << days;
  EXPECT_NE(days.find("\n3,toy,b,ratio,calm,2024-01-11,18446744073709551615,,\"[1, 2]\",0.1,"), std::string::npos)
      << days;
  EXPECT_LT(days.find(",d10\n"), days.find(",d20\n"));
  const std::string steps = swept_steps_csv(file_);
  EXPECT_TRUE(steps.starts_with("run,start,step,idle_km,")) << steps;
  EXPECT_NE(steps.find("\n3,05:30,1,"), std::string::npos) << steps;
}

TEST_F(SweepFileOf3, GivesFinishedDaysBack) {
  begin_sweep(file_, small_sweep(), {"k1", "k2", "k2"});
  add("k1", 10);
  add("k2", 20);
  const auto days = read_finished(file_);
  ASSERT_EQ(days.size(), 3U);
  EXPECT_EQ(days[0].variant, "a");
  EXPECT_EQ(days[0].controller, "ratio");
  EXPECT_EQ(days[0].totals.at("lost"), 10.0);
  EXPECT_EQ(days[2].totals.at("lost"), 20.0);
  EXPECT_EQ(days[2].totals.at("idle_km"), 0.1);
  EXPECT_EQ(days[2].totals.at("idle_km_after_7"), 0.5);
  EXPECT_EQ(days[2].seed, 18446744073709551615ULL);
  EXPECT_EQ(days[2].settings.at("x"), "[1, 2]");
}

TEST_F(SweepFileOf3, GivesWhatIsPlayedBackBeforeItsEnd) {
  note_origin_first();
  begin_sweep(file_, small_sweep(), {"k1", "k2", "k3"});
  EXPECT_EQ(read_origin(file_).text, "t") << "who looks in between wants to know too";
  add("k2", 20);
  const PlayedDays played = read_played(file_);
  ASSERT_EQ(played.days.size(), 1U);
  EXPECT_EQ(played.days[0].totals.at("lost"), 20.0);
  ASSERT_EQ(played.missing.size(), 2U);
  EXPECT_EQ(played.missing[1].variant, "b");
  EXPECT_TRUE(played.missing[1].totals.empty());
  EXPECT_EQ(played.first_missing, "1");
}

TEST_F(SweepFileOf3, KeepsHowLongDaysTook) {
  EXPECT_TRUE(seconds_of_results(file_).empty());
  begin_sweep(file_, small_sweep(), {"k1", "k2", "k3"});
  add("k1", 10);
  note_seconds(file_, "k1", 1.5);
  add("k3", 30);
  const auto other = folder_.path() / "other.sqlite";
  begin_results(other);
  add_result(other, "k2", {}, small_result(20));
  note_seconds(other, "k2", 2.5);
  merge_result(file_, other);
  merge_result(file_, other);
  const auto seconds = seconds_of_results(file_);
  ASSERT_EQ(seconds.size(), 3U);
  EXPECT_EQ(seconds.at("k1"), 1.5);
  EXPECT_EQ(seconds.at("k2"), 2.5);
  EXPECT_EQ(seconds.at("k3"), std::nullopt);
}

TEST_F(SweepFileOf3, KeepsWhyDaysFailedUntilTheyArePlayed) {
  EXPECT_TRUE(failures_in(file_).empty());
  begin_sweep(file_, small_sweep(), {"k1", "k2", "k3"});
  EXPECT_EQ(failed_days_csv(file_), "");
  note_failure(file_, "k2", "no luck");
  note_failure(file_, "k2", "no\npetrol");
  note_failure(file_, "k3", "none");
  add("k3", 30);
  EXPECT_EQ(failures_in(file_), (std::map<std::string, std::string>{{"k2", "no\npetrol"}}));
  EXPECT_EQ(failed_days_csv(file_),
            "run,scenario,variant,controller,faults,day,seed,balancing.p_ratio,x,reason\n"
            "2,toy,a,ratio,calm,2024-01-11,2,10,,\"no\npetrol\"\n");
  begin_sweep(file_, small_sweep(), {"k1", "k2", "k3"});
  EXPECT_EQ(failures_in(file_).size(), 1U) << "whoever goes on knows them";
  const auto asked_for = read_asked_for(file_);
  ASSERT_EQ(asked_for.size(), 3U);
  EXPECT_TRUE(asked_for[1].totals.empty());
  EXPECT_EQ(asked_for[2].totals.at("lost"), 30.0);
  add("k2", 20);
  EXPECT_EQ(failed_days_csv(file_), "");
}

TEST_F(SweepFileOf3, OfAVersionThatKeptNoFailuresHasNone) {
  begin_sweep(file_, small_sweep(), {"k1", "k2", "k3"});
  SQLite::Database(file_.string(), SQLite::OPEN_READWRITE).exec("DROP TABLE failed");
  EXPECT_TRUE(failures_in(file_).empty());
  begin_sweep(file_, small_sweep(), {"k1", "k2", "k3"});
  EXPECT_NO_THROW(note_failure(file_, "k1", "no luck"));
}

TEST_F(SweepFileOf3, GivesStepsBack) {
  begin_sweep(file_, small_sweep(), {"k1", "k2", "k1"});
  DayResult result = small_result(1);
  result.metrics.steps[1].flows.lost = 3;
  add_result(file_, "k1", {}, result);
  add_result(file_, "k2", {}, small_result(1));
  const auto days = read_finished_steps(file_, {"idle_km", "lost"});
  ASSERT_EQ(days.size(), 3U);
  EXPECT_EQ(days[2].starts, (std::vector<std::string>{"05:00", "05:30", "07:00"}));
  EXPECT_EQ(days[2].columns.at("lost"), (std::vector<double>{0.0, 3.0, 0.0}));
  EXPECT_EQ(days[1].columns.at("lost"), (std::vector<double>{0.0, 0.0, 0.0}));
  EXPECT_THROW(read_finished_steps(file_, {"luck"}), Error);
}

TEST_F(SweepFileOf3, SaysWhatItWasMadeFrom) {
  begin_sweep(file_, small_sweep(), {"k1", "k2", "k3"});
  EXPECT_THROW(read_origin(file_), Error);
  note_origin(file_, {.command = "c", .file = "a.yaml", .text = "old", .scenario = "s"});
  note_origin(file_, {.command = "c", .file = "a.yaml", .text = "new", .scenario = "s"});
  const SweepOrigin origin = read_origin(file_);
  EXPECT_EQ(origin.command, "c");
  EXPECT_EQ(origin.file, "a.yaml");
  EXPECT_EQ(origin.text, "new");
  EXPECT_EQ(origin.scenario, "s");
}

TEST_F(SweepFileOf3, TakesOverResultsOfOtherFilesOnce) {
  begin_sweep(file_, small_sweep(), {"k1", "k2", "k2"});
  add("k1", 10);
  const auto other = folder_.path() / "it's other.sqlite";
  begin_results(other);
  add_result(other, "k2", {}, small_result(20));
  merge_result(file_, other);
  const std::string days = swept_days_csv(file_);
  const std::string steps = swept_steps_csv(file_);
  merge_result(file_, other);
  EXPECT_EQ(read_finished(file_).at(2).totals.at("lost"), 20.0);
  EXPECT_EQ(swept_days_csv(file_), days);
  EXPECT_EQ(swept_steps_csv(file_), steps);
}

TEST_F(SweepFileOf3, QuotesNames) {
  Sweep sweep = small_sweep();
  sweep.days[0].scenario = "rush, hour";
  sweep.days[0].faults = "\"a\"";
  sweep.days[0].settings["x"] = "b\rc";
  begin_sweep(file_, sweep, {"k1", "k1", "k1"});
  add("k1", 10);
  const std::string days = swept_days_csv(file_);
  EXPECT_NE(days.find("\n1,\"rush, hour\",a,ratio,\"\"\"a\"\"\",2024-01-11,1,10,\"b\rc\",0.1,"), std::string::npos)
      << days;
}

TEST_F(SweepFileOf3, IsReadAfterAWriterThatWasKilled) {
  namespace fs = std::filesystem;
  begin_sweep(file_, small_sweep(), {"k1", "k1", "k1"});
  note_origin(file_, {.command = "c", .file = "a.yaml", .text = "t", .scenario = "s"});
  add("k1", 10);
  const std::string whole = swept_steps_csv(file_);
  const std::vector<std::function<void(const fs::path&)>> readers = {
      [](const fs::path& file) { EXPECT_TRUE(played_by_others(file, {"k1"}).empty()); },
      [](const fs::path& file) { EXPECT_EQ(read_finished(file).size(), 3U); },
      [](const fs::path& file) { EXPECT_EQ(read_finished_steps(file, {"lost"}).size(), 3U); },
      [](const fs::path& file) { EXPECT_EQ(read_origin(file).command, "c"); },
      [](const fs::path& file) { EXPECT_NE(swept_days_csv(file), ""); },
      [&](const fs::path& file) { EXPECT_EQ(swept_steps_csv(file), whole); },
  };
  // What such a writer leaves is what lies there while one has more to write than it keeps in memory.
  SQLite::Database writer(file_.string(), SQLite::OPEN_READWRITE);
  writer.exec("PRAGMA cache_size = 1");
  writer.exec("BEGIN IMMEDIATE");
  writer.exec(
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 9999) "
      "INSERT INTO steps (key, start) SELECT 'k1', i FROM n");
  for (std::size_t reader = 0; reader < readers.size(); ++reader) {
    const fs::path left = folder_.path() / std::to_string(reader);
    fs::create_directory(left);
    for (const char* name : {"sweep.sqlite", "sweep.sqlite-journal"}) {
      fs::copy_file(folder_.path() / name, left / name);
    }
    EXPECT_NO_THROW(readers[reader](left / "sweep.sqlite")) << reader;
  }
}

TEST_F(SweepFileOf3, RefusesAnotherFile) {
  folder_.write("sweep.sqlite", "dear diary");
  EXPECT_THROW(begin_sweep(file_, small_sweep(), {"k1", "k2", "k3"}), Error);
  EXPECT_THROW(read_finished(folder_.path() / "none.sqlite"), Error);
}

}  // namespace
}  // namespace evbal
