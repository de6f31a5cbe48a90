#include "experiments/study/design/tuning.hpp"

#include "experiments/study/design/study_file.hpp"
#include "experiments/study/statistics/tuning_outcome.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace evbal {
namespace {

const std::string tuning_head =
    "schema: 1\nscenario: base.yaml\ndays: [2024-01-03, 2024-01-01]\nseeds: [7]\n"
    "faults: {calm: none, again: none}\nobjective: {idle_km: 1, lost: 20}\n";
const std::string two_variants =
    "variants:\n"
    "  - {controller: ratio, settings: {engine: cuts}, search: {balancing.p_ratio: {from: 1, to: 100}}}\n"
    "  - {name: t, controller: turnover, search: {balancing.p_shortage: {from: 4, to: 64}, engine: [cuts, ipopt]}}\n";

class TuningOfToy : public ::testing::Test {
 protected:
  TuningOfToy() { folder_.write("base.yaml", "schema: 1\ncity: toy-5\nday: 2024-01-01\nseed: 1\n"); }

  Tuning read(const std::string& text, bool quick = false) const {
    return read_tuning(folder_.write("tuning.yaml", text), quick);
  }

  void expect_refused(const std::string& text, int line, const std::string& word) const {
    try {
      read(text);
      FAIL() << "was accepted, expected a refusal with " << word;
    } catch (const Error& error) {
      const std::string what = error.what();
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      EXPECT_NE(what.find("tuning.yaml:" + std::to_string(line) + ": "), std::string::npos) << what;
      EXPECT_NE(what.find(word), std::string::npos) << what;
    }
  }

 private:
  Folder folder_;
};

/// Days that lose as many passengers as `lost` says of their settings.
std::vector<FinishedDay> played(const Sweep& round, const std::function<double(const SweptDay&)>& lost) {
  std::vector<FinishedDay> days;
  for (const auto& day : round.days) {
    days.push_back({.variant = day.variant, .faults = day.faults, .day = day.day, .seed = day.seed});
    days.back().totals = {{"idle_km", 1.0}, {"lost", lost(day)}};
  }
  return days;
}

TEST_F(TuningOfToy, SpreadsItsCandidatesOverTheRanges) {
  const Tuning tuning = read(tuning_head + "candidates: 8\n" + two_variants);
  const auto contests = contests_of(tuning);
  ASSERT_EQ(contests.size(), 2U);
  ASSERT_EQ(contests[0].candidates.size(), 6U) << "a quarter of them comes later";
  EXPECT_EQ(shown(contests[0].candidates[0].settings.at(0).value), "cuts");
  EXPECT_EQ(contests[0].candidates[0].settings.at(1).value.number(), 10.0);  // the middle of 1 and 100 by ratio
  EXPECT_EQ(contests[1].candidates[2].settings.at(0).value.number(), 32.0);  // three quarters of the way
  EXPECT_EQ(shown(contests[1].candidates[0].settings.at(1).value), "cuts");  // a third
  EXPECT_EQ(shown(contests[1].candidates[1].settings.at(1).value), "ipopt");
}

TEST_F(TuningOfToy, GivesEachVariantTheSameDaysAndKeepsTheBest) {
  const Tuning tuning = read(tuning_head + "candidates: 4\n" + two_variants);
  auto contests = contests_of(tuning);
  const auto lost = [](const SweptDay& day) {
    return day.variant == "ratio" ? 1.0 / std::stod(day.settings.at("balancing.p_ratio"))
                                  : std::stod(day.settings.at("balancing.p_shortage"));
  };
  std::vector<std::size_t> days;
  while (undecided(contests)) {
    const Sweep round = round_of(tuning, contests);
    EXPECT_EQ(round.settings, (std::vector<std::string>{"engine", "balancing.p_ratio", "balancing.p_shortage"}));
    const auto of_first =
        std::count_if(round.days.begin(), round.days.end(), [](const SweptDay& day) { return day.variant == "ratio"; });
    EXPECT_EQ(round.days.size(), 2U * static_cast<std::size_t>(of_first));
    days.push_back(round.days.size());
    judge_round(tuning, played(round, lost), contests);
  }
  EXPECT_EQ(days, (std::vector<std::size_t>{2 * 3 * 2, 2 * 4 * 2, 2 * 2 * 4, 2 * 2 * 4}));
  EXPECT_GT(contests[0].candidates.front().settings.at(1).value.number(), 100.0);
  EXPECT_LT(contests[1].candidates.front().settings.at(0).value.number(), 4.0);
  for (const auto& contest : contests) {
    EXPECT_EQ(contest.candidates.front().sums.size(), 4U);
    EXPECT_EQ(contest.candidates.back().sums.size(), 2U);
    EXPECT_EQ(contest.candidates.size(), 5U);
  }

  const Folder folder;
  const Tuned winning = judged_winners(tuning, contests);
  const Tuned tuned = read_tuned(folder.write("tuned.yaml", tuned_yaml(winning)));
  ASSERT_EQ(tuned.size(), 2U);
  const TunedVariant& turnover = tuned.at({"base", "t"});
  EXPECT_EQ(turnover.controller.name, "turnover");
  EXPECT_EQ(shown(turnover.settings.at(0).value), shown(contests[1].candidates.front().settings.at(0).value));
  ASSERT_TRUE(turnover.outcome);
  EXPECT_EQ(turnover.outcome->tried, 5);
  EXPECT_EQ(turnover.outcome->days, 3 * 2 + 2 * 4);
  EXPECT_EQ(turnover.outcome->edges, winning.at({"base", "t"}).outcome->edges);
  EXPECT_EQ(tuned_yaml(tuned), tuned_yaml(winning));
}

TEST_F(TuningOfToy, IsWrittenWhateverScenariosAndSettingsAreCalled) {
  const std::string odd = "rush: \"hour\", #1";
  std::string text = tuning_head +
                     "candidates: 2\nvariants:\n  - {controller: ratio, settings: {engine: \"a, 'b': #c\"}, " +
                     "search: {balancing.p_ratio: {from: 1, to: 100}}}\n";
  const std::string one = "scenario: base.yaml";
  text.replace(text.find(one), one.size(), "scenarios: {'" + odd + "': base.yaml}");
  const Tuning tuning = read(text);
  const auto contests = contests_of(tuning);
  const Folder folder;
  const Tuned tuned = read_tuned(folder.write("tuned.yaml", tuned_yaml(winners(tuning, contests))));
  ASSERT_TRUE(tuned.contains({odd, "ratio"}));
  EXPECT_EQ(shown(tuned.at({odd, "ratio"}).settings.at(0).value), "a, 'b': #c");
  const std::string csv = candidates_csv(tuning, contests);
  EXPECT_NE(csv.find("\n\"rush: \"\"hour\"\", #1\",ratio,1,"), std::string::npos) << csv;
}

TEST_F(TuningOfToy, RefusesAScenarioThatTakesWhatWasTunedElsewhere) {
  std::string text = tuning_head + "candidates: 8\n" + two_variants;
  const std::string one = "scenario: base.yaml";
  text.replace(text.find(one), one.size(), "scenarios: {one: {file: base.yaml, tuned_as: two}}");
  expect_refused(text, 2, "is not tuned itself");
}

TEST_F(TuningOfToy, MayBeCutShort) {
  const Tuning tuning = read(tuning_head + "candidates: 8\n" + two_variants, true);
  EXPECT_EQ(contests_of(tuning).front().candidates.size(), 3U);
}

TEST_F(TuningOfToy, RefusesTestDaysAndWhatElseIsWrong) {
  const std::string start = "schema: 1\nscenario: base.yaml\nseeds: [7]\nobjective: {lost: 1}\ncandidates: 4\n";
  expect_refused(start + "days: [2024-01-01, 2024-01-11]\n" + two_variants, 6, "`2024-01-11` is no training day");
  const std::string days = "days: [2024-01-01]\n";
  const auto variant = [&](const std::string& text) { return start + days + "variants:\n  - {" + text + "}\n"; };
  expect_refused(variant("controller: ratio"), 8, "search");
  expect_refused(variant("controller: ratio, search: {}"), 8, "to search");
  expect_refused(variant("controller: ratio, search: {balancing.p_ratio: {from: 0, to: 3}}"), 8, "is no range");
  expect_refused(variant("controller: ratio, search: {balancing.p_ratio: {from: 1, to: 3, most: 2}}"), 8, "");
  expect_refused(variant("controller: ratio, search: {day: [2024-01-02]}"), 8, "cannot be a setting");
  expect_refused(
      "schema: 1\nscenario: base.yaml\nseeds: [7]\ncandidates: 4\nobjective: {lots: 1}\n" + days + two_variants, 5,
      "did you mean `lost`");
}

}  // namespace
}  // namespace evbal
