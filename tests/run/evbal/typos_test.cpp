#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace evbal {
namespace {

namespace fs = std::filesystem;

struct Typo {
  std::string arguments;
  std::string meant;
};

/// One line with the word that was meant, and status 2.
void expect_suggestion(const Ended& ended, const Typo& typo) {
  EXPECT_EQ(ended.status, 2) << typo.arguments;
  EXPECT_EQ(ended.out, "") << typo.arguments;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_NE(ended.err.find("did you mean `" + typo.meant + "`?"), std::string::npos) << ended.err;
}

/// Typos in what `evbal run` is told beside its scenario.
const std::vector<Typo>& typos_of_run() {
  static const std::vector<Typo> all = {
      {"--controler robust", "--controller"},
      {"--seeed=3", "--seed"},
      {"--controller robst", "robust"},
      {"--engine ctus", "cuts"},
      {"--transport inprc", "inproc"},
      {"--faults stadum.yaml", "stadium.yaml"},
      {"--set balancing.p_shortge=20", "p_shortage"},
      {"--set blancing.tau=1", "balancing"},
      {"--set balancing.supply=point", "points"},
      {"--set demand=poison", "poisson"},
      {"--set city=toy-6", "toy-5"},
      {"--set 'expect=[{metric: srved, at_least: 1}]'", "served"},
      {"--set 'faults={schema: 1, faults: [{name: a, type: charger.outge}]}'", "charger.outage"},
      {"--set 'clock={strat: \"05:00\"}'", "start"},
  };
  return all;
}

TEST(Typos, OfARunGetASuggestion) {
  const CommandLine line;
  for (const Typo& typo : typos_of_run()) {
    expect_suggestion(line.evbal("run toy.yaml " + typo.arguments), typo);
  }
  EXPECT_FALSE(fs::exists(line.path() / "runs"));
}

TEST(Typos, OfOtherCommandsGetASuggestion) {
  const CommandLine line;
  ASSERT_EQ(line.evbal("sweep sweep-small.yaml --quick --quiet --out swept").status, 0);
  line.scenario("bad.yaml", "controler: robust\n");
  for (const Typo& typo : std::vector<Typo>{
           {"rnu toy.yaml", "run"},
           {"list citis", "cities"},
           {"list --jsn cities", "--json"},
           {"run toi.yaml", "toy.yaml"},
           {"run bad.yaml", "controller"},
           {"show toy.yaml --set regions_per_proces=2", "regions_per_process"},
           {"sweep sweep-smal.yaml", "sweep-small.yaml"},
           {"sweep sweep-small.yaml --executor slrum", "slurm"},
           {"tune reproduce-paper-tunig.yaml", "reproduce-paper-tuning.yaml"},
           {"compare swept --against ratoi", "ratio"},
           {"compare swept --against ratio --metric losst", "lost"},
           {"compare swept --against ratio --at idle_kn", "idle_km"},
           {"report swept --against ratoi", "ratio"},
           {"ingest gsp", "gps"},
           {"fit toy-4", "toy-5"},
           {"verify shenzen-54", "shenzhen-54"},
           {"replay swept --quite", "--quiet"},
       }) {
    expect_suggestion(line.evbal(typo.arguments), typo);
  }
}

// With stand-ins for what installs and builds: `run-day` adds nothing to what `evbal run` says, nor takes from it.
TEST(Typos, OfRunDayGetASuggestion) {
  const CommandLine line;
  const fs::path tools = line.path() / "tools";
  fs::create_directories(tools);
  fs::copy_file(EVBAL_SOURCE_DIR "/tools/run-day", tools / "run-day");
  for (const char* name : {"setup", "build"}) {
    std::ofstream(tools / name) << "#!/bin/sh\n";
    fs::permissions(tools / name, fs::perms::owner_all);
  }
  fs::create_directory_symlink(EVBAL_SOURCE_DIR "/experiments", line.path() / "experiments");
  fs::create_directories(line.path() / "build/release");
  fs::create_directory_symlink(fs::path(EVBAL_PROGRAM).parent_path(), line.path() / "build/release/bin");
  for (const Typo& typo : typos_of_run()) {
    expect_suggestion(line.command("tools/run-day " + typo.arguments), typo);
  }
  EXPECT_FALSE(fs::exists(line.path() / "runs"));
}

}  // namespace
}  // namespace evbal
