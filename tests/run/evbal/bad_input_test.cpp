#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// Refused with status 2 and one line that holds `word`; nothing is left behind.
void expect_refused(const CommandLine& line, const std::string& arguments, const std::string& word) {
  const Ended ended = line.evbal("run " + arguments);
  EXPECT_EQ(ended.status, 2) << arguments;
  EXPECT_NE(ended.err.find(word), std::string::npos) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_FALSE(fs::exists(line.path() / "runs")) << arguments;
  EXPECT_FALSE(fs::exists(line.path() / "new")) << arguments;
}

TEST(BadInput, OfTheCommandLineIsRefused) {
  const CommandLine line;
  expect_refused(line, "no.yaml", "no.yaml: cannot be read");
  expect_refused(line, "morning.yaml --controller robst --out new", "did you mean `robust`");
  expect_refused(line, "morning.yaml --day 2020-01-01", "2024-01-11");
  expect_refused(line, "morning.yaml --transport udp", "`dds`, `inproc`");
  expect_refused(line, "morning.yaml --engine simplex", "`ipopt`");
  expect_refused(line, "morning.yaml --seed -1", "--seed");
  expect_refused(line, "morning.yaml --seed 1.5", "--seed");
  expect_refused(line, "morning.yaml --regions-per-process 0", "--regions-per-process");
  expect_refused(line, "morning.yaml --faults no.yaml --out new", "no.yaml: cannot be read");
  expect_refused(line, "morning.yaml --bogus", "--bogus");
  expect_refused(line, "morning.yaml --out \"$(printf 'new\\377')\"", "word 4 of the command line is not UTF-8");
  expect_refused(line, "morning.yaml --out \"$(printf 'new\\nx')\"", "word 4 of the command line holds a line break");
}

TEST(BadInput, OfAScenarioIsRefusedByItsLine) {
  const CommandLine line;
  line.scenario("bad.yaml", "stpe: 30min\n");
  expect_refused(line, "bad.yaml --out new", "bad.yaml:14: unknown key `stpe`");
  line.scenario("bad.yaml", "name: ../new\n");
  expect_refused(line, "bad.yaml", "bad.yaml:14: name `../new` may not");
  line.scenario("bad.yaml", "name: a/b\n");
  expect_refused(line, "bad.yaml", "bad.yaml:14: name `a/b` may not");
  line.scenario("bad.yaml", "name: \"M\xfcnchen\"\n");
  expect_refused(line, "bad.yaml", "bad.yaml:14: is not UTF-8");
  line.scenario("bad.yaml", "---\nfleet: {vehicles: 12}\n");
  expect_refused(line, "bad.yaml", "bad.yaml:15: a second document");
  line.scenario("bad.yaml", "passengers: {patience: [1min, 99999999999h]}\n");
  expect_refused(line, "bad.yaml", "bad.yaml:14: `99999999999h` is out of range");
  line.scenario("bad.yaml", "fleet: {vehicles: 12.5}\n");
  expect_refused(line, "bad.yaml", "bad.yaml:14: `12.5` is no whole number");
  line.scenario("bad.yaml", "expect: [{metric: srved, at_least: 1}]\n");
  expect_refused(line, "bad.yaml", "did you mean `served`");
}

TEST(BadInput, OfAScheduleIsRefusedByItsLine) {
  const CommandLine line;
  const auto fault = [&line](const std::string& what) {
    std::ofstream(line.path() / "faults.yaml") << "schema: 1\nseed: 1\nfaults:\n  - {name: a, " + what + "}\n";
  };
  fault("type: charger.outage, target: {regions: [5]}, start: \"08:00\", duration: 1h, magnitude: 1");
  expect_refused(line, "morning.yaml --faults faults.yaml", "faults.yaml:4");
  fault("type: charger.outage, target: {regions: [0]}, start: \"08:00\", duration: 60, magnitude: 1");
  expect_refused(line, "morning.yaml --faults faults.yaml", "`60` is no duration");
}

TEST(BadInput, AnOutputDirectoryInUseIsLeftAlone) {
  const CommandLine line;
  fs::create_directory(line.path() / "mine");
  std::ofstream(line.path() / "mine" / "letter.txt") << "dear";
  expect_refused(line, "morning.yaml --out mine", "not an empty directory");
  expect_refused(line, "morning.yaml --out morning.yaml", "not an empty directory");
  EXPECT_EQ(std::distance(fs::directory_iterator(line.path() / "mine"), {}), 1);
}

TEST(BadInput, OfReportAndReplayIsRefused) {
  const CommandLine line;
  EXPECT_EQ(line.evbal("report nowhere").status, 2);
  EXPECT_EQ(line.evbal("replay nowhere").status, 2);
  EXPECT_EQ(line.evbal("").status, 2);
  EXPECT_EQ(line.evbal("frobnicate").status, 2);
  EXPECT_EQ(line.evbal("--help").status, 0);
}

}  // namespace
}  // namespace evbal
