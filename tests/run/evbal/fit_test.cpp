#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;

TEST(Fit, GivesTheModelThatIsShipped) {
  const CommandLine line;
  const Ended ended = line.evbal("fit toy-5 --out model.json");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(text_of(line.path() / "model.json") == text_of(EVBAL_SOURCE_DIR "/experiments/cities/toy-5/model.json"))
      << "fit the shipped cities again: evbal fit toy-5, evbal fit san-francisco-54";
  EXPECT_NE(ended.out.find("\n   500 "), std::string::npos) << "the threshold table";
}

TEST(Fit, TakesTheTransitionsOfDrivers) {
  const CommandLine line;
  std::string table = "from,region,state,cars,becomes,in_region,share\n";
  for (const char* from : {"05:00", "07:00", "10:00", "16:00", "19:00", "22:00"}) {
    for (const std::string region : {"r1", "r2", "r3", "r4", "r5"}) {
      table += std::string(from) + "," + region + ",vacant,9,vacant," + region + ",1\n";
      table += std::string(from) + "," + region + ",occupied,9,vacant,r3,1\n";
    }
  }
  std::ofstream(line.path() / "transitions.csv") << table;
  const Ended ended = line.evbal("fit toy-5 --transitions transitions.csv --out model.json");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(text_of(line.path() / "model.json").find("[[0.0,0.0,1.0,0.0,0.0],[0.0,0.0,1.0,0.0,0.0],"),
            std::string::npos);
  const Ended refused = line.evbal("fit san-francisco-54 --transitions transitions.csv --out other.json");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("transitions.csv:2: the city has no region `r1`"), std::string::npos) << refused.err;
}

TEST(Fit, TakesOtherDays) {
  const CommandLine line;
  const Ended ended =
      line.evbal("fit toy-5 --train 2024-01-04 2024-01-08 --test 2024-01-01 2024-01-05 --out model.json");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("demand: 5 training days on record"), std::string::npos) << ended.out;
  const Ended refused = line.evbal("fit toy-5 --train 2030-01-01 2030-01-08 --out other.json");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("toy-5 has no day from 2030-01-01 to 2030-01-08; its days are from"), std::string::npos)
      << refused.err;
}

TEST(Fit, RefusesACityThatItCannotFit) {
  const CommandLine line;
  const Ended unknown = line.evbal("fit atlantis");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("atlantis"), std::string::npos) << unknown.err;
  ASSERT_EQ(line.evbal("ingest synthetic --out brief --train-days 2").status, 0);
  const Ended brief = line.evbal("fit ./brief");
  EXPECT_EQ(brief.status, 2);
  EXPECT_NE(brief.err.find("three at least"), std::string::npos) << brief.err;
  EXPECT_FALSE(fs::exists(line.path() / "brief" / "model.json"));
}

}  // namespace
}  // namespace evbal
