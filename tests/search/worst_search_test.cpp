#include "experiments/search/worst_search.hpp"

#include "experiments/search/path_csv.hpp"
#include "tests/search/ingredients_fixture.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

using testing::made_up_harm;
using testing::made_up_harms;
using testing::small_ingredients;

RC_GTEST_PROP(WorstSearch, TriesAsManyAsItMayAndTheSameAgain, (std::uint32_t seed)) {
  const Ingredients ingredients = small_ingredients(seed);
  const std::size_t budget = *rc::gen::inRange<std::size_t>(1, 60);
  const auto trials = search_worst(ingredients, budget, made_up_harms);
  RC_ASSERT(trials.size() == budget);
  std::size_t most = 1;
  for (std::size_t i = 0; i < first_draws(budget); ++i) {
    RC_ASSERT(trials[i].stage == "draw");
    most = std::max(most, trials[i].picks.size());
  }
  for (std::size_t i = 0; i < budget; ++i) {
    RC_ASSERT(trials[i].number == i + 1 && trials[i].parent <= i);
    RC_ASSERT(trials[i].picks.size() <= most);
    RC_ASSERT(keeps_guard(trials[i].picks, ingredients));
    RC_ASSERT(trials[i].harm == made_up_harm(trials[i].picks));
  }
  RC_ASSERT(path_csv(search_worst(ingredients, budget, made_up_harms), ingredients) == path_csv(trials, ingredients));
}

TEST(WorstSearch, FindsMoreHarmThanAsManyDraws) {
  constexpr std::size_t budget = 300;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Ingredients ingredients = small_ingredients(seed);
    double drawn = 0.0;
    for (const auto& picks : random_draws(ingredients, budget)) {
      drawn = std::max(drawn, made_up_harm(picks));
    }
    const auto trials = search_worst(ingredients, budget, made_up_harms);
    EXPECT_GE(most_harmful(trials).harm, 1.2 * drawn) << "seed " << seed;
  }
}

}  // namespace
}  // namespace evbal
