#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace evbal {
namespace {

using Words = std::set<std::string>;

Words words_of_lines(const std::string& text) {
  std::istringstream stream(text);
  Words lines;
  for (std::string line; std::getline(stream, line);) {
    lines.insert(line);
  }
  return lines;
}

/// What bash offers for the last of the words that follow evbal, which a shell reads.
Words offered(const std::string& words) {
  const CommandLine line;
  const Ended ended =
      line.command("bash -c '. " EVBAL_SOURCE_DIR "/tools/deb/completion.bash; COMP_WORDS=(evbal " + words +
                   "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _evbal " EVBAL_PROGRAM
                   "; printf \"%s\\n\" ${COMPREPLY[@]+\"${COMPREPLY[@]}\"}'");
  EXPECT_EQ(ended.status, 0) << words;
  EXPECT_EQ(ended.err, "") << words;
  Words found = words_of_lines(ended.out);
  found.erase("");
  return found;
}

/// The first column of what `evbal list` prints, without its title.
Words listed_names(const std::string& kind) {
  const CommandLine line;
  std::istringstream table(line.evbal("list " + kind).out);
  Words names;
  std::string row;
  std::getline(table, row);
  while (std::getline(table, row)) {
    names.insert(row.substr(0, row.find(' ')));
  }
  return names;
}

TEST(Completion, OfCommands) {
  const CommandLine line;
  Words shown;
  std::istringstream help(line.evbal("--help").out);
  bool commands = false;
  for (std::string row; std::getline(help, row); commands = commands || row == "Subcommands:") {
    if (commands && row.starts_with("  ")) {
      shown.insert(row.substr(2, row.find(' ', 2) - 2));
    }
  }
  EXPECT_GT(shown.size(), 10u);
  EXPECT_EQ(offered("\"\""), shown);
  EXPECT_EQ(offered("re"), (Words{"replay", "report"}));
  EXPECT_EQ(offered("ingest s"), (Words{"stations", "synthetic"}));
  EXPECT_EQ(offered("rnu"), Words{});
}

TEST(Completion, OfOptions) {
  EXPECT_EQ(offered("run --co"), (Words{"--controller", "--coordinator"}));
  EXPECT_EQ(offered("run toy.yaml --seed 7 --tr"), Words{"--transport"});
  EXPECT_EQ(offered("ingest gps --sta"), Words{"--stations"});
  EXPECT_EQ(offered("--v"), Words{"--version"});
  EXPECT_EQ(offered("report --"),
            (Words{"--against", "--days", "--faults", "--figures", "--help", "--out", "--scenario", "--variant"}));
}

TEST(Completion, OfWhatIsListed) {
  EXPECT_EQ(offered("run \"\""), listed_names("scenarios"));
  EXPECT_EQ(offered("fit \"\""), listed_names("cities"));
  EXPECT_EQ(offered("sweep \"\""), listed_names("studies"));
  EXPECT_EQ(offered("tune \"\""), listed_names("studies"));
  EXPECT_EQ(offered("run --controller \"\""), listed_names("controllers"));
  EXPECT_EQ(offered("run toy.yaml --faults \"\""), listed_names("faults"));
  EXPECT_EQ(offered("compare swept --metric \"\""), listed_names("metrics"));
  EXPECT_EQ(offered("compare swept --at \"\""), (Words{"idle_km", "idle_km_after_7", "lost", "lost_after_7"}));
  EXPECT_EQ(offered("verify toy"), Words{"toy-5"});
}

TEST(Completion, OfWhatHelpShowsInBraces) {
  EXPECT_EQ(offered("list \"\""),
            (Words{"benchmarks", "cities", "controllers", "faults", "metrics", "scenarios", "studies"}));
  EXPECT_EQ(offered("run --transport \"\""), (Words{"dds", "inproc"}));
  EXPECT_EQ(offered("run --engine \"\""), (Words{"cuts", "ipopt"}));
}

// Bash takes `=` for a word.
TEST(Completion, OfWordsWithAnEqualsSign) {
  EXPECT_EQ(offered("run --controller = rob"), Words{"robust"});
  EXPECT_EQ(offered("run --transport ="), (Words{"dds", "inproc"}));
  EXPECT_EQ(offered("run --set balancing.p_shortage = 20 to"), Words{"toy.yaml"});
  EXPECT_EQ(offered("run --set balancing.p_shortage ="), Words{});
}

TEST(Completion, LeavesFilesAndFreeTextToTheShell) {
  EXPECT_EQ(offered("run --out \"\""), Words{});
  EXPECT_EQ(offered("replay \"\""), Words{});
  EXPECT_EQ(offered("run toy.yaml \"\""), Words{});
  EXPECT_EQ(offered("fit --train 2024-01-08 2024-01-10 toy"), Words{"toy-5"});
}

}  // namespace
}  // namespace evbal
