#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>

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
