#include "experiments/search/moves.hpp"

#include "tests/search/ingredients_fixture.hpp"
#include "tests/support/yaml_of.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

using testing::small_ingredients;

/// Whether a whole number of minutes or regions is a rounded value of the range.
bool rounded_in(double value, Range range) {
  return value >= range.low - 0.5 && value <= range.high + 0.5;
}

/// Whether a fault is one that its entry could give: only what the entry leaves open differs.
void check_fault(const Pick& pick, const Ingredients& ingredients) {
  const Request& request = ingredients.entries.at(pick.entry);
  const Fault& fault = pick.fault;
  const double at = fault.start + ingredients.context.clock.start;
  RC_ASSERT(
      (request.start ? rounded_in(at, request.start->range) : at >= request.arrivals.from && at < request.arrivals.to));
  RC_ASSERT(rounded_in(fault.duration, request.duration.range));
  RC_ASSERT(std::includes(request.target.candidates.begin(), request.target.candidates.end(), fault.regions.begin(),
                          fault.regions.end()));
  RC_ASSERT(std::adjacent_find(fault.regions.begin(), fault.regions.end()) == fault.regions.end());
  const double count = static_cast<double>(fault.regions.size());
  RC_ASSERT((request.target.pick ? rounded_in(count, request.target.pick->range)
                                 : fault.regions == request.target.candidates));
  RC_ASSERT(fault.type == request.type->effect && fault.visible == request.visible);
}

RC_GTEST_PROP(Moves, KeepGuardAndEntries, (std::uint32_t seed)) {
  const Ingredients ingredients = small_ingredients(seed);
  const std::vector<Picks> draws = random_draws(ingredients, 2);
  Picks picks = draws.front();
  const MoveStock stock{.most = picks.size() + 2, .harmful = *rc::gen::element(Picks{}, draws.back())};
  RandomStream stream(seed, Purpose::fault, {});
  for (int i = 0; i < 20; ++i) {
    const auto next = moved(ingredients, picks, stock, stream);
    RC_ASSERT(next.has_value());
    RC_ASSERT(next->picks != picks);
    picks = next->picks;
    RC_ASSERT(picks.size() <= stock.most);
    RC_ASSERT(std::count_if(picks.begin(), picks.end(), [](const Pick& pick) { return pick.entry == 1; }) <= 1);
    for (const auto& pick : picks) {
      check_fault(pick, ingredients);
    }
    const Schedule schedule = schedule_of(picks, ingredients);
    const std::string yaml =
        yaml_of([&](YamlWriter& out) { write_schedule(out, schedule, ingredients.context.clock); });
    RC_ASSERT(testing::read_text(yaml) == schedule);  // the reader of schedules holds the guard against it
  }
}

TEST(Moves, TakeNewFaultsFromTheHarmfulOnes) {
  const Ingredients ingredients = small_ingredients(1);
  Pick harmful = random_draws(ingredients, 1).front().front();
  harmful.fault.start = 7;
  harmful.fault.duration = 11;
  RandomStream stream(1, Purpose::fault, {});
  constexpr int moves = 400;
  int taken = 0;
  for (int i = 0; i < moves; ++i) {
    const auto next = moved(ingredients, {}, {.most = 1, .harmful = {harmful}}, stream);
    ASSERT_TRUE(next.has_value());
    const Fault& fault = next->picks.front().fault;
    taken += fault.start == 7 && fault.duration == 11 ? 1 : 0;
  }
  EXPECT_NEAR(taken, 0.75 * moves, 0.1 * moves);
}

RC_GTEST_PROP(Moves, LikelyHoldsMostDraws, (std::uint32_t seed)) {
  const std::string text = *rc::gen::element<std::string>(
      "{normal: {mean: 10, sd: 3}}", "{lognormal: {median: 10, sigma: 0.4}}", "{exponential: {mean: 10}}",
      "{uniform: {min: 1, max: 20}}", "{normal: {mean: 10, sd: 3, min: 9}}", "7");
  YamlMap map(YamlValue::parse("x: " + text, "quantity"));
  const Quantity quantity = read_quantity(map.require("x"), Unit::number, {0.0, 100.0});
  const Range likely = quantity.likely();
  RC_ASSERT(likely.low >= quantity.range.low && likely.high <= quantity.range.high);
  RandomStream stream(seed, Purpose::fault, {});
  int within = 0;
  for (int i = 0; i < 1000; ++i) {
    const double drawn = quantity.draw(stream);
    within += drawn >= likely.low && drawn <= likely.high ? 1 : 0;
  }
  RC_ASSERT(within >= 950);
}

TEST(Ingredients, AreRefusedIfNothingCanBeTried) {
  const auto message = [](const std::string& faults, const std::string& head) -> std::string {
    try {
      random_draws(testing::ingredients_of(faults, head), 1);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const std::string entry = "  - {" + testing::outage.substr(1) + "}\n";
  EXPECT_NE(message("  []\n", "").find("no fault is given"), std::string::npos);
  EXPECT_NE(message(entry, "resolved: true\n").find("nothing is left open"), std::string::npos);
  EXPECT_NE(message(entry + entry, "").find("is there twice"), std::string::npos);
  EXPECT_NE(message(entry, "guard: {min_working_points: 36}\n").find("keep the guard"), std::string::npos);
  EXPECT_EQ(message(entry, ""), "");
}

}  // namespace
}  // namespace evbal
