#include "experiments/study/design/benchmark.hpp"

#include "experiments/study/design/sweep.hpp"
#include "experiments/study/design/tuning.hpp"
#include "tests/folder.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

const std::string kBenchmark = R"(schema: 1
name: small-1
objective: {idle_km: 1, lost: 20}
candidates: 2
parts:
  toy:
    scenario: day.yaml
    days: [2024-01-11, 2024-01-12]
    seeds: [1]
    faults: {calm: none, own: scenario}
    training: {days: [2024-01-02], seeds: [7], faults: {calm: none}}
    bound: {prices: [5, 20], seeds: [1]}
    reference: {controller: nominal, settings: {balancing.p_shortage: [6, 12]}}
entries:
  flow:
    settings: {engine: cuts}
    search: {balancing.p_flow: {from: 6, to: 200}}
    factors: {balancing.p_flow: [0.5, 2]}
)";

class BenchmarkOfToy : public testing::Test {
 protected:
  BenchmarkOfToy() {
    folder_.write("day.yaml", "schema: 1\ncity: toy-5\nday: 2024-01-11\nseed: 1\ncontroller: nominal\n");
  }

  Benchmark read(const std::string& text = kBenchmark) const {
    return read_benchmark(folder_.write("benchmark.yaml", text));
  }

  void expect_refused(const std::string& was, const std::string& now, const std::string& words) const {
    std::string text = kBenchmark;
    try {
      read(text.replace(text.find(was), was.size(), now));
      FAIL() << "was accepted: " << now;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }

  Folder folder_;
};

TEST_F(BenchmarkOfToy, MakesATuningOfTheEntry) {
  const Benchmark benchmark = read();
  const Entry entry{"flow", {}, benchmark.entries.at("flow")};
  const Tuning tuning =
      read_tuning(folder_.write("tuning.yaml", tuning_yaml(benchmark, benchmark.parts[0], entry)), false);
  EXPECT_EQ(tuning.candidates, 2);
  ASSERT_EQ(tuning.variants.size(), 1U);
  EXPECT_EQ(tuning.variants[0].name, "entry");
  EXPECT_EQ(tuning.variants[0].search[0].path, "balancing.p_flow");
}

TEST_F(BenchmarkOfToy, MakesASweepOfReferenceAndEntry) {
  const Benchmark benchmark = read();
  const Entry entry{"flow", {}, benchmark.entries.at("flow")};
  const std::string settings =
      examined_settings(entry.settings, {{"balancing.p_flow", YamlValue::parse("30", "tuned")}});
  const Sweep sweep = read_sweep(folder_.write("sweep.yaml", sweep_yaml(benchmark.parts[0], entry, settings)));
  ASSERT_EQ(sweep.days.size(), 16U) << "2 points each, 2 days, 1 seed, 2 schedules";
  EXPECT_EQ(sweep.days.front().variant, "reference");
  EXPECT_EQ(sweep.days.back().variant, "entry");
  EXPECT_EQ(sweep.days.back().settings.at("balancing.p_flow"), "60") << "twice what was tuned";
  EXPECT_EQ(sweep.days.back().settings.at("engine"), "cuts");
  EXPECT_EQ(scenario_of(sweep.days.back()).planning.controller, "flow");
}

TEST_F(BenchmarkOfToy, ItsDigestIsOfItsFileAndScenarios) {
  const std::string digest = read().digest;
  EXPECT_EQ(read().digest, digest);
  std::string text = kBenchmark;
  EXPECT_NE(read(text.replace(text.find("[5, 20]"), 7, "[5, 30]")).digest, digest);
  folder_.write("day.yaml", "schema: 1\ncity: toy-5\nday: 2024-01-11\nseed: 2\ncontroller: nominal\n");
  EXPECT_NE(read().digest, digest);
}

TEST_F(BenchmarkOfToy, SaysWhatIsWrongAndWhere) {
  expect_refused("name: small-1", "name: a/b", "benchmark.yaml:2: name `a/b`");
  expect_refused("candidates: 2", "candidates: 1", "benchmark.yaml:4: `1` is out of range");
  expect_refused("prices: [5, 20]", "prices: [20, 5]", "benchmark.yaml:12: prices ascend");
  expect_refused("    seeds: [1]\n", "", "seeds");
  expect_refused("search:", "serch:", "serch");
  const Entry entry{"flow", {}, {.settings = {}, .search = {}, .factors = read().entries.at("flow").factors}};
  try {
    examined_settings(entry.settings, {});
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("`balancing.p_flow` is neither set nor searched"), std::string::npos)
        << error.what();
  }
}

TEST(Benchmarks, ShippedOnesMakeSweepsAndTuningsOfAllTheyKnow) {
  for (const auto& file : std::filesystem::directory_iterator(test::in_source("experiments/benchmarks"))) {
    const Benchmark benchmark = read_benchmark(file.path());
    const Folder folder;
    for (const auto& [controller, settings] : benchmark.entries) {
      const Entry entry{controller, {}, settings};
      for (const BenchmarkPart& part : benchmark.parts) {
        const Tuning tuning = read_tuning(folder.write("tuning.yaml", tuning_yaml(benchmark, part, entry)), false);
        std::vector<Setting> tuned;
        for (const SearchAxis& axis : tuning.variants[0].search) {
          tuned.push_back({axis.path, YamlValue::parse("10", "tuned")});
        }
        const Sweep sweep =
            read_sweep(folder.write("sweep.yaml", sweep_yaml(part, entry, examined_settings(settings, tuned))));
        EXPECT_EQ(scenario_of(sweep.days.back()).planning.controller, controller);
      }
    }
  }
}

}  // namespace
}  // namespace evbal
