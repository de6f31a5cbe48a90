#include "tools/evbal/study_line.hpp"

#include "experiments/study/design/benchmark.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

/// A part of two days with two seeds: the reference loses 100 at 10 km and 60 at 20 km, the entry has one setting.
struct OneSetting {
  Sweep sweep{};
  StudiedPart part{.name = "toy", .settings = {}, .days = {}, .bounds = {}};

  void add(const std::string& variant, const std::string& price, const std::string& day, std::uint64_t seed, double km,
           double lost) {
    SweptDay swept{.variant = variant,
                   .faults = "calm",
                   .day = day,
                   .seed = seed,
                   .settings = {{"price", price}},
                   .yaml = YamlValue::parse("{}", "toy")};
    sweep.days.push_back(swept);
    part.days.push_back({km, lost, ""});
  }

  OneSetting() {
    for (const std::uint64_t seed : {1, 2}) {
      for (const std::string day : {"d1", "d2"}) {
        add(reference_variant, "1", day, seed, 10, 100);
        add(reference_variant, "2", day, seed, 20, 60);
      }
    }
    add(entry_variant, "", "d1", 1, 12, 10);
    add(entry_variant, "", "d1", 2, 18, 70);
    add(entry_variant, "", "d2", 1, 15, 40);
    add(entry_variant, "", "d2", 2, 15, 39);
  }
};

TEST(StudyLine, CountsDaysOfAnEntryWithOneSettingAndSumsTheirSeeds) {
  const OneSetting studied;
  const StudyLine line{.file = {},
                       .benchmark = {},
                       .benchmark_digest = {},
                       .version = {},
                       .controller = {},
                       .coordinator = {},
                       .coordinator_digest = {},
                       .parts = {studied.part}};
  const auto results = results_of(line, {studied.sweep});
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0].days, 2);
  // 80 and 79 of the 160 that two seeds of the reference lose at 30 km, each and 1/2.
  EXPECT_NEAR(results[0].difference, std::sqrt(80.5 / 160.5 * 79.5 / 160.5) - 1.0, 1e-12);
  EXPECT_EQ(results[0].verdict, "fewer");
}

}  // namespace
}  // namespace evbal
