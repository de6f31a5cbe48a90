#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// As a text in JavaScript; CSV files hold no backquotes.
std::string quoted(const fs::path& file) {
  return "`" + text_of(file) + "`";
}

/// Opens the page in Chromium, without a network, and gives what page_checks.js finds wrong, or "all hold".
std::string checked(const fs::path& page, const std::string& files, const std::string& option) {
  const fs::path folder = page.parent_path() / "checked";
  fs::create_directories(folder);
  const std::string script = text_of(EVBAL_SOURCE_DIR "/tests/run/evbal/page_checks.js");
  std::ofstream(folder / "page.html") << text_of(page) << "<script>" << script << "checkPage(" << files
                                      << ");</script>";
  const std::string command = std::string(EVBAL_CHROMIUM) +
                              " --headless --no-sandbox --disable-gpu --disable-quic --no-first-run"
                              " --disable-background-networking --disable-component-update --disable-sync"
                              " --host-resolver-rules='MAP * ~NOTFOUND' --virtual-time-budget=20000 " +
                              option + " --user-data-dir=" + (folder / "user").string() + " --dump-dom file://" +
                              (folder / "page.html").string() + " >" + (folder / "dom.html").string() + " 2>" +
                              (folder / "err.txt").string();
  if (std::system(command.c_str()) != 0) {
    return text_of(folder / "err.txt");
  }
  const std::string dom = text_of(folder / "dom.html");
  const std::string start = "<pre id=\"checks\">";
  const auto from = dom.rfind(start);
  return from == std::string::npos ? "the checks did not end"
                                   : dom.substr(from + start.size(), dom.find("</pre>", from) - from - start.size());
}

TEST(ReportPage, OpensWithoutNetworkMovesAndShowsTheNumbersOfTheCsv) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("run morning.yaml --out a --quiet").status, 0);
  const fs::path run = line.path() / "a";
  const std::string files = "{run: {steps: " + quoted(run / "steps.csv") + ", regions: " + quoted(run / "regions.csv") +
                            ", faults: " + quoted(run / "faults.csv") + "}}";
  EXPECT_EQ(checked(run / "report.html", files, ""), "all hold");
  EXPECT_EQ(checked(run / "report.html", files, "--blink-settings=preferredColorScheme=0"), "all hold");  // dark
}

TEST(ReportPage, OfASweepShowsTheNumbersOfTheCsv) {
  const CommandLine line;
  std::ofstream(line.path() / "calm.yaml") << "schema: 1\ncity: toy-5\nday: 2024-01-11\nseed: 1\ntransport: inproc\n"
                                              "clock: {start: \"07:00\", end: \"10:00\"}\n";
  for (const std::string day : {"2024-01-11", "2024-01-12"}) {
    ASSERT_EQ(line.evbal("bound calm.yaml --prices 2 10 --quiet --day " + day).status, 0);
  }
  std::ofstream(line.path() / "prices.yaml") << "schema: 1\n"
                                                "scenario: calm.yaml\n"
                                                "days: [2024-01-11, 2024-01-12]\n"
                                                "seeds: [1]\n"
                                                "variants:\n"
                                                "  - controller: ratio\n"
                                                "    settings: {engine: cuts}\n"
                                                "  - controller: turnover\n"
                                                "    settings: {engine: cuts, balancing.p_shortage: [12, 24]}\n";
  ASSERT_EQ(line.evbal("sweep prices.yaml --jobs 2 --out s --quiet").status, 0);
  const Ended ended = line.evbal("report s");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out, "s/report.html\n");
  const fs::path folder = line.path() / "s";
  EXPECT_NE(text_of(folder / "report.html").find("\"bounds\":[{"), std::string::npos);
  EXPECT_EQ(checked(folder / "report.html", "{sweep: {days: " + quoted(folder / "days.csv") + "}}", ""), "all hold");
  EXPECT_EQ(line.evbal("report s --against robust").status, 2);
  EXPECT_EQ(line.evbal("report s s").status, 2);
}

TEST(ReportPage, OfSomeOfASweepsDaysShowsNoOthers) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("sweep page-small.yaml --quick --quiet --jobs 2 --out s").status, 0);
  ASSERT_EQ(line.evbal("report s --days 2024-01-09 --out some.html").status, 0);
  const std::string some = text_of(line.path() / "some.html");
  EXPECT_NE(some.find("\"day\":\"2024-01-09\""), std::string::npos);
  EXPECT_EQ(some.find("\"day\":\"2024-01-10\""), std::string::npos);
  EXPECT_NE(some.find("Some of a sweep's days, as asked for."), std::string::npos);
  EXPECT_EQ(line.evbal("report s --variant nobody").status, 2);
  ASSERT_EQ(line.evbal("run toy.yaml --transport inproc --out day --quiet").status, 0);
  const Ended without_sweep = line.evbal("report day --days 2024-01-12");
  EXPECT_EQ(without_sweep.status, 2);
  EXPECT_NE(without_sweep.err.find("there is none among the directories"), std::string::npos) << without_sweep.err;
}

TEST(ReportPage, ShowsTheVerdictAndTheFirstFigureOnTheFirstScreen) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("sweep page-small.yaml --quick --quiet --jobs 2 --out s").status, 0);
  ASSERT_EQ(line.evbal("report s").status, 0);
  const fs::path folder = line.path() / "s";
  const std::string files = "{study: {figures: 6}}";
  EXPECT_EQ(checked(folder / "report.html", files, "--window-size=1280,900"), "all hold");
  EXPECT_EQ(checked(folder / "report.html", files, "--window-size=1280,900 --blink-settings=preferredColorScheme=0"),
            "all hold");  // dark
}

}  // namespace
}  // namespace evbal
