#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// What a command prints with `--json`, which is one JSON document and nothing else.
Json json_of(const CommandLine& line, const std::string& arguments) {
  const Ended ended = line.evbal(arguments + " --json");
  EXPECT_EQ(ended.status, 0) << ended.err;
  const Json json = Json::parse(ended.out, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << arguments << ": " << ended.out;
  return json;
}

TEST(Set, IsPlayedAndRecorded) {
  const CommandLine line;
  const Ended ended = line.evbal("run morning.yaml --quiet --out set --set balancing.p_shortage=20 --set seed=5");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string resolved = text_of(line.path() / "set/scenario.resolved.yaml");
  EXPECT_NE(resolved.find("\n  p_shortage: 20\n"), std::string::npos) << resolved;
  EXPECT_NE(resolved.find("\nseed: 5\n"), std::string::npos) << resolved;
  EXPECT_EQ(line.evbal("replay set --quiet").status, 0);
}

TEST(Latest, LeadsToTheNewestRunThatIsComplete) {
  const CommandLine line;
  const fs::path latest = line.path() / "runs/latest";
  ASSERT_EQ(line.evbal("run morning.yaml --quiet").status, 0);
  EXPECT_EQ(fs::read_symlink(latest), "morning-2024-01-11-nominal-seed1");
  ASSERT_EQ(line.evbal("run morning.yaml --quiet --seed 2").status, 0);
  EXPECT_EQ(fs::read_symlink(latest), "morning-2024-01-11-nominal-seed2");
  ASSERT_EQ(line.evbal("run morning.yaml --quiet --seed 3 --out elsewhere").status, 0);
  EXPECT_EQ(fs::read_symlink(latest), "morning-2024-01-11-nominal-seed2");
  EXPECT_EQ(line.evbal("replay runs/latest --quiet").status, 0);
  // A report on all runs has each of them once.
  ASSERT_EQ(line.evbal("report runs").status, 0);
  const std::string page = text_of(line.path() / "runs/report.html");
  EXPECT_EQ(page.find("runs/latest"), std::string::npos);
}

TEST(Latest, LeavesAFolderOfThatNameAlone) {
  const CommandLine line;
  fs::create_directories(line.path() / "runs/latest");
  ASSERT_EQ(line.evbal("run morning.yaml --quiet").status, 0);
  EXPECT_FALSE(fs::is_symlink(line.path() / "runs/latest"));
  EXPECT_EQ(std::distance(fs::directory_iterator(line.path() / "runs"), {}), 2);
}

TEST(Json, IsPrintedInPlaceOfTables) {
  const CommandLine line;
  const Json runs = json_of(line, "run morning.yaml --quiet --out one");
  EXPECT_EQ(runs["report"], "one/report.html");
  ASSERT_EQ(runs["runs"].size(), 1U);
  EXPECT_EQ(runs["runs"][0]["folder"], "one");
  EXPECT_EQ("\"" + runs["runs"][0]["digest"].get<std::string>() + "\"", line.summary("one", "digest"));
  EXPECT_TRUE(runs["runs"][0]["without_faults"]["metrics"].contains("lost"));

  ASSERT_EQ(line.evbal("sweep sweep-small.yaml --quick --quiet --out swept").status, 0);
  const Json compared = json_of(line, "compare swept --against ratio");
  ASSERT_FALSE(compared.empty());
  EXPECT_TRUE(compared[0].contains("p_holm"));
  const Json against_both = json_of(line, "compare swept --against ratio turnover --at idle_km");
  EXPECT_EQ(against_both.front()["reference_variant"], "ratio");
  EXPECT_EQ(against_both.back()["reference_variant"], "turnover");

  for (const char* kind : {"cities", "scenarios", "controllers", "metrics", "faults", "studies"}) {
    EXPECT_FALSE(json_of(line, std::string("list ") + kind).empty()) << kind;
  }
  const Json shown = json_of(line, "show morning.yaml --set balancing.tau=1");
  EXPECT_EQ(shown["scenario"]["balancing"]["tau"], 1);
  EXPECT_EQ(shown["sources"]["balancing.tau"], "--set");
}

TEST(Json, HoldsWhatManyDrawsCameTo) {
  const CommandLine line;
  std::ofstream(line.path() / "drawn.yaml") << "schema: 1\nseed: 1\nruns: 2\nfaults:\n  - {name: jam, type: "
                                               "travel.slow, target: {pick: 2}, start: \"08:00\", "
                                               "duration: 40min, magnitude: {uniform: {min: 1.5, max: 4}}}\n";
  const Json drawn = json_of(line, "run morning.yaml --quiet --faults drawn.yaml --out drawn");
  EXPECT_EQ(drawn["folder"], "drawn");
  EXPECT_EQ(drawn["controllers"][0]["draws"], 2);
  EXPECT_TRUE(drawn["controllers"][0]["metrics"]["lost"].contains("median"));
}

TEST(Json, HoldsHowGoodAFitIs) {
  const CommandLine line;
  const std::string table = line.evbal("fit toy-5 --out model.json").out;
  const Json fit = json_of(line, "fit toy-5 --out model.json");
  EXPECT_EQ(fit["model"], "model.json");
  EXPECT_EQ(fit["turnover"]["phi"], Json::parse(text_of(line.path() / "model.json"))["turnover"]["phi"]);
  for (const char* series : {"demand", "completions"}) {
    const Json& of = fit[series];
    EXPECT_EQ(of["regions"].size(), 5U);
    EXPECT_EQ(of["thresholds"][2]["resample"], 50);
    EXPECT_TRUE(of["thresholds"][2]["coverage"].contains("both"));
    EXPECT_TRUE(of["thresholds"][4]["coverage"].is_null());
    std::array<char, 64> row{};
    std::snprintf(row.data(), row.size(), "%-12s test %*s %6.1f %6.1f  ", series, 19, "",
                  100.0 * of["test"]["of_seasonal_mean"][0].get<double>(),
                  100.0 * of["test"]["of_seasonal_mean"][1].get<double>());
    EXPECT_NE(table.find(row.data()), std::string::npos) << row.data() << "\n" << table;
  }
  ASSERT_EQ(fit["trips"].size(), 10U);
  std::array<char, 64> period{};
  std::snprintf(period.data(), period.size(), "\n05:00  %d pairs of regions; %.1f %% of",
                fit["trips"][0]["pairs"].get<int>(), 100.0 * fit["trips"][0]["within"].get<double>());
  EXPECT_EQ(fit["trips"][0]["start"], "05:00");
  EXPECT_NE(table.find(period.data()), std::string::npos) << period.data() << "\n" << table;
  EXPECT_NE(text_of(line.path() / "err.txt").find("demand: "), std::string::npos) << "what is done next";
}

TEST(Json, HoldsADiagnosis) {
  const CommandLine line;
  const auto finding = [](const Json& findings, const std::string& what) {
    const auto found = std::find_if(findings.begin(), findings.end(), [&](const Json& one) {
      return one["what"].get<std::string>().find(what) != std::string::npos;
    });
    return found == findings.end() ? Json(what + " was not looked at") : *found;
  };
  const Json well = Json::parse(line.evbal("doctor --json").out);
  EXPECT_EQ(finding(well, "UDP over 127.0.0.1"),
            Json({{"what", "UDP over 127.0.0.1"}, {"well", true}, {"cure", nullptr}}));
  EXPECT_TRUE(finding(well, "Ipopt 3.")["well"].is_null());
  const Ended unfit = line.evbal("doctor --json", "ulimit -n 20;");
  EXPECT_EQ(unfit.status, 3);
  const Json files = finding(Json::parse(unfit.out), " open files");
  EXPECT_EQ(files["well"], false);
  EXPECT_NE(files["cure"].get<std::string>().find("`ulimit -n 1024`"), std::string::npos) << files;
}

TEST(CrossCheck, ChangesNothingButItsOwnEntry) {
  const CommandLine line;
  const std::string run = "run morning.yaml --quiet --engine cuts --json --out ";
  const auto solver = [&](const std::string& folder, const std::string& check) {
    const Ended ended = line.evbal(run + folder + " --set cross_check=" + check);
    EXPECT_EQ(ended.status, 0) << ended.err;
    return Json::parse(ended.out)["runs"][0]["solver"];
  };
  EXPECT_FALSE(solver("off", "off").contains("cross_check"));
  const Json first = solver("first", "ipopt");
  EXPECT_EQ(first["cross_check"]["engine"], "ipopt");
  EXPECT_EQ(first["cross_check"]["plans"], 1);
  EXPECT_LT(first["cross_check"]["max_relative_difference"], 2e-6);
  const Json every = solver("every", "every");
  EXPECT_EQ(every["cross_check"]["plans"], every["solves"]);
  EXPECT_EQ(every["cross_check"]["unsolved"], 0);
  EXPECT_LT(every["cross_check"]["max_relative_difference"], 2e-6);
  EXPECT_EQ(line.summary("first", "digest"), line.summary("off", "digest"));
  EXPECT_EQ(line.summary("every", "digest"), line.summary("off", "digest"));
  EXPECT_EQ(line.evbal("replay first --quiet").status, 0);
}

TEST(CrossCheck, IsNoneWhereIpoptOrNobodySolves) {
  const CommandLine line;
  for (const char* options : {"--engine ipopt", "--engine cuts --controller greedy"}) {
    const Json runs = json_of(line, std::string("run morning.yaml --quiet --set cross_check=every ") + options);
    EXPECT_FALSE(runs["runs"][0]["solver"].contains("cross_check")) << options;
  }
}

}  // namespace
}  // namespace evbal
