#include "tests/run/evbal/command_line.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <signal.h>

#include <chrono>
#include <set>
#include <thread>

namespace evbal {
namespace {

namespace fs = std::filesystem;

std::set<std::int64_t> writers(const fs::path& run, const std::string& table) {
  const SQLite::Database database((run / "run.sqlite").string());
  SQLite::Statement query(database, "SELECT DISTINCT origin_process_id FROM " + table);
  std::set<std::int64_t> ids;
  while (query.executeStep()) {
    ids.insert(query.getColumn(0).getInt64());
  }
  return ids;
}

TEST(Run, LeavesACompleteDirectoryAndATable) {
  const CommandLine line;
  const Ended ended = line.evbal("run morning.yaml --out a");
  ASSERT_EQ(ended.status, 0) << ended.err;
  for (const char* file :
       {"scenario.resolved.yaml", "summary.json", "steps.csv", "regions.csv", "run.sqlite", "report.html"}) {
    EXPECT_TRUE(fs::exists(line.path() / "a" / file)) << file;
  }
  EXPECT_EQ(line.summary("a", "steps"), "6");
  EXPECT_EQ(line.summary("a", "fleet_conserved"), "true");
  EXPECT_EQ(line.summary("a", "fallbacks"), "0");
  EXPECT_TRUE(line.summary("a", "program").starts_with("\"evbal ")) << line.summary("a", "program");
  EXPECT_EQ(line.summary("a", "pack_digest").size(), 34U);
  EXPECT_EQ(line.summary("a", "model_digest").size(), 34U);
  EXPECT_NE(ended.out.find("idle km"), std::string::npos);
  EXPECT_NE(ended.err.find("08:00  served"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("[outage]"), std::string::npos) << ended.err;
}

TEST(Run, TellsWhereTheTimeOfItsTicksGoes) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("run morning.yaml --out a --quiet --transport dds --log-level info").status, 0);
  const auto timings = nlohmann::json::parse(text_of(line.path() / "a" / "summary.json")).at("timings");
  EXPECT_EQ(timings.size(), 4U) << timings;
  const int ticks = timings.at("conductor").at("departures").at("times");
  EXPECT_GT(ticks, 0);
  EXPECT_EQ(timings.at("agents").at("live").at("times"), 5 * ticks);
  EXPECT_EQ(timings.at("coordinator").at("plan").at("times"), timings.at("conductor").at("plan").at("times"));
  EXPECT_TRUE(timings.at("faults").contains("send"));
  EXPECT_NE(text_of(line.path() / "a/processes/agent-0.log").find(" info agent-0: is participant 3"),
            std::string::npos);
  EXPECT_NE(text_of(line.path() / "err.txt").find(" info evbal: 8 processes"), std::string::npos);
  EXPECT_NE(text_of(line.path() / "a" / "report.html").find("wait for the reports"), std::string::npos);
  EXPECT_EQ(line.evbal("replay a --quiet").status, 0) << "in one process, which takes other times";
}

TEST(Run, RecordsWhatAPlanCostsByTerm) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("run morning.yaml --out a --quiet").status, 0);
  const SQLite::Database database((line.path() / "a" / "run.sqlite").string());
  SQLite::Statement query(database,
                          "SELECT count(*), max(abs(provenance_objective - (SELECT sum(cost) FROM plan_costs "
                          "WHERE plan_costs.tick = plans.tick))), min(provenance_objective) FROM plans");
  ASSERT_TRUE(query.executeStep());
  EXPECT_GT(query.getColumn(0).getInt(), 0);
  ASSERT_TRUE(query.getColumn(1).isFloat());
  EXPECT_LT(query.getColumn(1).getDouble(), 1e-6);
  EXPECT_GT(query.getColumn(2).getDouble(), 0.0);
}

TEST(Run, IsPairedWithTheSameDayWithoutFaults) {
  const CommandLine line;
  const Ended ended = line.evbal("run morning.yaml --out a");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("nominal: what the faults cost"), std::string::npos) << ended.out;
  EXPECT_TRUE(text_of(line.path() / "a" / "faults.csv").starts_with("metric,with,without,cost"));
  EXPECT_NE(text_of(line.path() / "a" / "summary.json").find("without_faults"), std::string::npos);
  std::ofstream(line.path() / "none.yaml") << "schema: 1\nfaults: []\n";
  ASSERT_EQ(line.evbal("run morning.yaml --faults none.yaml --out b").status, 0);
  EXPECT_EQ(line.summary("a/without-faults", "digest"), line.summary("b", "digest"));
  EXPECT_NE(line.summary("a", "digest"), line.summary("b", "digest"));
  EXPECT_FALSE(fs::exists(line.path() / "b" / "without-faults"));
  EXPECT_EQ(line.evbal("replay a").status, 0);
  EXPECT_EQ(line.evbal("replay a/without-faults").status, 0);
}

TEST(Run, KeepsItsMarkIfItsPageCannotBeWritten) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("run morning.yaml --out a --quiet").status, 0);
  const auto page = fs::file_size(line.path() / "a" / "report.html");
  const std::string limit = "ulimit -f " + std::to_string(page / 1024 - 1) + "; trap '' XFSZ; ";
  const std::string script = "cd " + line.path().string() + " && " + limit + EVBAL_PROGRAM +
                             " run morning.yaml --out b --quiet >out.txt 2>err.txt";
  const int code = std::system(("bash -c \"" + script + "\"").c_str());
  EXPECT_EQ(WEXITSTATUS(code), 3);
  EXPECT_NE(text_of(line.path() / "err.txt").find("report.html: cannot be written: File too large"), std::string::npos)
      << text_of(line.path() / "err.txt");
  EXPECT_TRUE(fs::exists(line.path() / "b" / "INCOMPLETE"));
  EXPECT_FALSE(fs::exists(line.path() / "b" / "report.html"));
  EXPECT_EQ(line.evbal("report b").status, 2);
  EXPECT_EQ(line.evbal("run morning.yaml --out b --quiet").status, 0) << "a run that broke off is made anew";
  EXPECT_EQ(line.evbal("report a --out /dev/full").status, 3);
  EXPECT_NE(text_of(line.path() / "err.txt").find("No space left on device"), std::string::npos);
}

TEST(Run, TakesADirectoryOfItsOwnEachTime) {
  const CommandLine line;
  EXPECT_EQ(line.evbal("run morning.yaml --controller none --quiet").out, "runs/morning-2024-01-11-none-seed1\n");
  EXPECT_EQ(line.evbal("run morning.yaml --controller none --quiet").out, "runs/morning-2024-01-11-none-seed1-2\n");
}

TEST(Run, PutsSeveralControllersSideBySide) {
  const CommandLine line;
  line.scenario("two.yaml", "");
  std::string text = text_of(line.path() / "two.yaml");
  text.replace(text.find("[nominal]"), 9, "[none, greedy]");
  std::ofstream(line.path() / "two.yaml") << text;
  const Ended ended = line.evbal("run two.yaml --out both");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(line.summary("both/none", "controller"), "\"none\"");
  EXPECT_EQ(line.summary("both/greedy", "controller"), "\"greedy\"");
  EXPECT_TRUE(fs::exists(line.path() / "both" / "report.html"));
  EXPECT_EQ(line.evbal("report both --out page.html").status, 0);
  EXPECT_NE(text_of(line.path() / "page.html").find("\"label\":\"greedy\""), std::string::npos);
}

TEST(Run, GivesOneDigestOverEveryTransport) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("run morning.yaml --out a").status, 0);
  const Ended over_dds = line.evbal("run morning.yaml --transport dds --out b");
  ASSERT_EQ(over_dds.status, 0) << over_dds.err;
  ASSERT_EQ(line.evbal("run morning.yaml --transport dds --regions-per-process 3 --out c").status, 0);
  ASSERT_EQ(line.evbal("run morning.yaml --seed 2 --out d").status, 0);
  EXPECT_EQ(line.summary("b", "digest"), line.summary("a", "digest"));
  EXPECT_EQ(line.summary("c", "digest"), line.summary("a", "digest"));
  EXPECT_NE(line.summary("d", "digest"), line.summary("a", "digest"));
  EXPECT_EQ(line.summary("b", "agents"), "5");
  EXPECT_EQ(line.summary("c", "agents"), "2");
}

TEST(Run, IsPlayedByProcessesOfTheirOwnOverDds) {
  const CommandLine line;
  const pid_t launcher = line.start("run morning.yaml --transport dds --out a");
  ASSERT_EQ(wait_for(launcher), 0) << text_of(line.path() / "err.txt");
  const auto agents = writers(line.path() / "a", "reports");
  const auto coordinator = writers(line.path() / "a", "plans");
  const auto injector = writers(line.path() / "a", "injector");
  EXPECT_EQ(agents.size(), 5);
  EXPECT_EQ(writers(line.path() / "a", "departures"), agents);
  EXPECT_EQ(coordinator.size(), 1);
  EXPECT_EQ(injector.size(), 1);
  std::set<std::int64_t> all = agents;
  all.insert(coordinator.begin(), coordinator.end());
  all.insert(injector.begin(), injector.end());
  all.insert(launcher);
  EXPECT_EQ(all.size(), 8);  // nobody is anybody else, and nobody is the launcher
}

/// The process of the run in `folder` that has this name; 0 if there is none.
pid_t process_of(const fs::path& folder, const std::string& name) {
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string line = text_of(entry.path() / "cmdline");
    if (line.find(folder.string()) != std::string::npos && line.find('\0' + name + '\0') != std::string::npos) {
      return std::atoi(entry.path().filename().c_str());
    }
  }
  return 0;
}

TEST(Run, IsTheSameIfAProcessIsKilledMeanwhile) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("run morning.yaml --controller robust --out a --quiet").status, 0);
  const fs::path run = line.path() / "b";
  const pid_t launcher =
      line.start("run morning.yaml --transport dds --controller robust --quiet --out " + run.string());
  const auto under_way = [&] {
    const std::string mark = text_of(run / "INCOMPLETE");
    return mark.find("of 36 ticks") != std::string::npos && mark.find("recorded 0 ") == std::string::npos;
  };
  for (int i = 0; i < 6000 && !under_way(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  const pid_t agent = process_of(run, "agent-2");
  ASSERT_GT(agent, 0);
  EXPECT_EQ(kill(agent, SIGKILL), 0);
  ASSERT_EQ(wait_for(launcher), 0) << text_of(line.path() / "err.txt");
  EXPECT_EQ(line.summary("b", "digest"), line.summary("a", "digest"));
  EXPECT_EQ(line.summary("b", "restarts"), "1");
  EXPECT_EQ(writers(run, "departures").size(), 6U);
  EXPECT_FALSE(fs::exists(run / "journals"));
  const Ended replay = line.evbal("replay b --quiet");
  EXPECT_EQ(replay.status, 0) << replay.err;
}

TEST(Run, EndsItsProcessesOnCtrlC) {
  signal(SIGINT, SIG_DFL);  // ignored where this test runs in the background
  const CommandLine line;
  const pid_t launcher = line.start(
      "run morning.yaml --transport dds --controller robust --out a "
      "--set clock.start=05:00 --set clock.end=24:00 --set clock.plan_every=5min");
  const fs::path mark = line.path() / "a" / "INCOMPLETE";
  for (int i = 0; i < 6000 && text_of(mark).find("of 228 ticks") == std::string::npos; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kill(launcher, SIGINT);
  EXPECT_EQ(wait_for(launcher), 3) << text_of(line.path() / "err.txt");
  EXPECT_NE(text_of(mark).find("of 228 ticks"), std::string::npos);
  for (const auto& entry : fs::directory_iterator("/proc")) {
    EXPECT_EQ(text_of(entry.path() / "cmdline").find(line.path().string()), std::string::npos) << entry.path();
  }
}

TEST(Run, FailsWhatWasExpected) {
  const CommandLine line;
  line.scenario("high.yaml", "expect:\n  - {metric: served, at_least: 1000000}\n  - {metric: lost, at_least: 0}\n");
  const Ended ended = line.evbal("run high.yaml --out a");
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("served is"), std::string::npos) << ended.err;
  EXPECT_EQ(ended.err.find("lost is"), std::string::npos) << ended.err;
  EXPECT_TRUE(fs::exists(line.path() / "a" / "summary.json"));
}

}  // namespace
}  // namespace evbal
