#include "common/digest.hpp"
#include "tests/run/evbal/command_line.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <functional>
#include <string>

namespace evbal {
namespace {

using Json = nlohmann::ordered_json;

/// A benchmark of a morning of the toy city, and a study of `flow` in it.
class StudyOfToy : public testing::Test {
 protected:
  StudyOfToy() {
    write("day.yaml",
          "schema: 1\ncity: toy-5\nday: 2024-01-11\nseed: 1\ncontroller: nominal\n"
          "clock: {start: \"07:00\", end: \"10:00\", tick: 5min, step: 30min, plan_every: 10min}\n");
    write("small.yaml",
          "schema: 1\nname: small-1\nobjective: {idle_km: 1, lost: 20}\ncandidates: 2\nparts:\n  toy:\n"
          "    scenario: day.yaml\n    days: [2024-01-11, 2024-01-12]\n    seeds: [1]\n    faults: {calm: none}\n"
          "    training: {days: [2024-01-02], seeds: [7], faults: {calm: none}}\n"
          "    bound: {prices: [5], seeds: [1]}\n"
          "    reference: {controller: nominal, settings: {engine: cuts, balancing.p_shortage: [1, 6, 24, 96]}}\n"
          "entries:\n  flow: {settings: {engine: cuts}, search: {balancing.p_flow: {from: 6, to: 200}},\n"
          "         factors: {balancing.p_flow: [0.1, 1, 2]}}\n");
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(line_.path() / name) << text; }
  std::string read(const std::string& name) const { return text_of(line_.path() / name); }

  Ended study(const std::string& more) const {
    return line_.evbal("study small.yaml --controller flow --quiet " + more);
  }

  /// The line of `name`, changed, with a digest that fits.
  void forge(const std::string& name, const std::function<void(Json& content)>& change) const {
    Json line = Json::parse(read(name));
    change(line["content"]);
    line["digest"] = text_digest(line["content"].dump());
    write("forged.json", line.dump() + "\n");
  }

  Ended verify(const std::string& name) const { return line_.evbal("study verify " + name + " --seed 3 --quiet"); }

  CommandLine line_;
};

TEST_F(StudyOfToy, WritesALineThatHoldsForAnyNumberOfJobs) {
  const Ended one = study("--out one --jobs 1");
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_NE(one.out.find("Verdict: "), std::string::npos) << one.out;
  ASSERT_EQ(study("--out two --jobs 2").status, 0);
  const Json first = Json::parse(read("one/line.json"));
  EXPECT_EQ(first["content"], Json::parse(read("two/line.json"))["content"]);
  EXPECT_EQ(first["content"]["parts"][0]["digests"].size(), 14U) << "four and three points on two days";
  EXPECT_TRUE(first["content"]["results"]["way"].is_number());
  EXPECT_GT(first["unsigned"]["processor_seconds"], 0.0);
  const Ended verified = verify("one/line.json");
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_NE(verified.out.find("small-1, flow: holds; played again 2 of 14 days"), std::string::npos) << verified.out;
  const Ended again = study("--out one");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(Json::parse(read("one/line.json"))["content"], first["content"]) << "nothing was left to be played";
  EXPECT_EQ(line_.evbal("compare one/toy --against reference --fronts").status, 0) << "a sweep like any other";
}

TEST_F(StudyOfToy, WhatWasChangedIsFoundOut) {
  ASSERT_EQ(study("--out mine").status, 0);
  std::string changed = read("mine/line.json");
  changed[changed.find("\"lost\":[") + 8] ^= 1;  // another digit
  write("changed.json", changed);
  const Ended touched = verify("changed.json");
  EXPECT_EQ(touched.status, 1);
  EXPECT_NE(touched.err.find("changed.json:1: the digest does not fit: the line was changed"), std::string::npos)
      << touched.err;

  forge("mine/line.json", [](Json& content) { content["results"]["verdict"] = "fewer still"; });
  const Ended boasted = verify("forged.json");
  EXPECT_EQ(boasted.status, 1);
  EXPECT_NE(boasted.err.find("its days come to other results"), std::string::npos) << boasted.err;

  forge("mine/line.json", [](Json& content) {
    for (Json& digest : content["parts"][0]["digests"]) {
      digest = "0123456789abcdef0123456789abcdef";
    }
  });
  const Ended invented = verify("forged.json");
  EXPECT_EQ(invented.status, 1);
  EXPECT_NE(invented.err.find("forged.json:1: toy, "), std::string::npos) << invented.err;
  EXPECT_NE(invented.err.find("played again it loses"), std::string::npos) << invented.err;

  forge("mine/line.json", [](Json& content) {
    for (Json& bound : content["parts"][0]["bounds"]) {
      bound["km"][0] = bound["km"][0].get<double>() + 0.01;  // too little to be seen in the rounded results
    }
  });
  const Ended bent = verify("forged.json");
  EXPECT_EQ(bent.status, 1);
  EXPECT_NE(bent.err.find("forged.json:1: "), std::string::npos) << bent.err;
}

TEST_F(StudyOfToy, WhatCannotBeComparedIsSaid) {
  ASSERT_EQ(study("--out mine").status, 0);
  forge("mine/line.json", [](Json& content) { content["version"] = "0.0.1"; });
  const Ended old = verify("forged.json");
  EXPECT_EQ(old.status, 2);
  EXPECT_NE(old.err.find("was made by evbal 0.0.1"), std::string::npos) << old.err;
  write("small.yaml", read("small.yaml") + "# changed\n");
  const Ended other = verify("mine/line.json");
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("is of benchmark small-1, of which small.yaml here differs"), std::string::npos)
      << other.err;
  write("text.json", "hello\n");
  EXPECT_NE(verify("text.json").err.find("text.json:1: is no line of `evbal study`"), std::string::npos);
  EXPECT_NE(line_.evbal("study small.yaml").err.find("--controller"), std::string::npos);
  EXPECT_EQ(line_.evbal("study small.yaml").status, 2);
}

TEST_F(StudyOfToy, TakesAControllerOfOnesOwn) {
  const std::string nearest = "python3 " EVBAL_SOURCE_DIR "/examples/nearest.py";
  const std::string entry = "--controller nearest --coordinator \"" + nearest + "\" --quiet --out own";
  const Ended played = line_.evbal("study small.yaml " + entry);
  ASSERT_EQ(played.status, 0) << played.err;
  const Json content = Json::parse(read("own/line.json"))["content"];
  EXPECT_EQ(content["controller"], "nearest");
  EXPECT_FALSE(content["coordinator_digest"].get<std::string>().empty());
  EXPECT_EQ(verify("own/line.json").status, 0);
  std::filesystem::copy_file(EVBAL_SOURCE_DIR "/examples/nearest.py", line_.path() / "other.py");
  std::ofstream(line_.path() / "other.py", std::ios::app) << "# another\n";
  const Ended other = line_.evbal("study verify own/line.json --quiet --coordinator \"python3 other.py\"");
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("is not the coordinator that it was made with"), std::string::npos) << other.err;
}

}  // namespace
}  // namespace evbal
