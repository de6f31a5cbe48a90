#include "experiments/study/statistics/tuning_outcome.hpp"

#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

class OutcomeOfToy : public ::testing::Test {
 protected:
  OutcomeOfToy()
      : tuning_((folder_.write("base.yaml", "schema: 1\ncity: toy-5\nday: 2024-01-01\nseed: 1\n"),
                 read_tuning(folder_.write("tuning.yaml",
                                           "schema: 1\nscenario: base.yaml\nseeds: [7]\nobjective: {lost: 1}\n"
                                           "days: [2024-01-01, 2024-01-02, 2024-01-03, 2024-01-04]\ncandidates: 4\n"
                                           "variants: [{controller: ratio, search: {balancing.p_ratio: "
                                           "{from: 1, to: 100}}}]\n"),
                             false))) {}

  /// What was found where the candidates, the best first, came to these sums.
  TuningOutcome outcome(const std::vector<std::pair<int, std::vector<double>>>& rounds_and_sums) const {
    auto contests = contests_of(tuning_);
    auto& candidates = contests.front().candidates;
    candidates.resize(rounds_and_sums.size(), candidates.front());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      candidates[i].round = rounds_and_sums[i].first;
      candidates[i].sums = rounds_and_sums[i].second;
    }
    return *judged_winners(tuning_, contests).begin()->second.outcome;
  }

 private:
  Folder folder_;
  Tuning tuning_;
};

TEST_F(OutcomeOfToy, SaysHowMuchWorseThanTheSecondTheWinnerMayBe) {
  const TuningOutcome found = outcome({{2, {10, 20, 30, 40}}, {1, {12, 19, 33, 44}}, {1, {11, 40}}});
  EXPECT_EQ(found.tried, 3);
  EXPECT_EQ(found.days, 10);
  EXPECT_EQ(found.objective, 25.0);
  EXPECT_EQ(found.over_second.replications, 4);
  EXPECT_DOUBLE_EQ(found.over_second.mean, 2.0);
  // R: t.test(c(2, -1, 3, 4)), 95 percent confidence interval: -1.43743..5.43743
  EXPECT_NEAR(found.over_second.low, -1.43743, 1e-4);
  EXPECT_NEAR(found.over_second.high, 5.43743, 1e-4);
  EXPECT_NEAR(found.regret(), 1.43743, 1e-4);
  EXPECT_EQ(found.over_first_round.replications, 4) << "12 + 19 is less than 11 + 40";
  EXPECT_EQ(outcome({{1, {10, 20, 30, 40}}, {1, {20, 31, 39, 52}}}).regret(), 0.0);
}

TEST_F(OutcomeOfToy, DoesNotClaimToKnowWhatOneDayCannotSay) {
  const TuningOutcome found = outcome({{1, {10}}, {1, {12}}});
  EXPECT_EQ(found.over_second.mean, 2.0);
  EXPECT_TRUE(std::isinf(found.regret()));
  EXPECT_EQ(outcome({{1, {10, 11, 12, 13}}}).over_second.replications, 0);
  const TuningOutcome itself = outcome({{1, {10, 20}}, {2, {11, 22}}});
  EXPECT_EQ(itself.over_first_round.mean, 0.0);
  EXPECT_EQ(itself.over_first_round.low, 0.0);
}

}  // namespace
}  // namespace evbal
