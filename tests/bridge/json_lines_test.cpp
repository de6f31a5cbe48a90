#include "coordinator/bridge/json_lines.hpp"

#include "common/error.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace evbal {
namespace {

/// Of three regions with two vacant cars and one low-battery car each; the fourth says nothing.
std::vector<Report> reports() {
  std::vector<Report> all(3);
  for (int i = 0; i < 3; ++i) {
    auto& report = all[static_cast<std::size_t>(i)];
    report = {.tick = 4,
              .region = i,
              .vacant = 2,
              .low_battery = 1,
              .chargeable = 1,
              .plugged_since = {3},
              .reach_m = {700},
              .bound = {{i, 25, Errand::charge, 1}},
              .origin = {}};
    report.origin.process_id = 4711;
  }
  return all;
}

City city_of(int regions, bool top_up = false) {
  City city;
  city.regions.resize(static_cast<std::size_t>(regions));
  city.charging.top_up = top_up;
  return city;
}

void expect_refused(const std::string& line, const std::string& words, bool top_up = false) {
  try {
    read_answer(line, "line 9 of `me`", reports(), city_of(4, top_up));
    FAIL() << "was accepted: " << line;
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("line 9 of `me`: ")) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

std::string move(const std::string& fields) {
  return R"({"moves": [{)" + fields + "}]}";
}

TEST(BridgeLines, AskWithEveryFieldButTheOrigin) {
  Tick tick;
  tick.tick = 4;
  tick.effects = {{.type = EffectType::demand_scale, .region = 2, .magnitude = 1.5, .visible = true},
                  {.type = EffectType::demand_scale, .region = 1, .magnitude = 3.0, .visible = false},
                  {.type = EffectType::charger_outage, .region = 1, .visible = true},
                  {.type = EffectType::solver_fail}};
  const std::string line = question_line(tick, reports());
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const auto question = nlohmann::json::parse(line);
  EXPECT_EQ(question.at("tick"), 4);
  const auto& report = question.at("reports").at(2);
  EXPECT_EQ(report.at("region"), 2);
  EXPECT_EQ(report.at("vacant"), 2);
  EXPECT_EQ(report.at("plugged_since"), nlohmann::json({3}));
  EXPECT_EQ(report.at("chargeable"), 1);
  EXPECT_EQ(report.at("reach_m"), nlohmann::json({700}));
  EXPECT_EQ(report.at("bound").at(0).at("errand"), "charge");
  EXPECT_EQ(report.at("bound").at(0).at("minute"), 25);
  EXPECT_FALSE(report.contains("origin"));
  const auto& told = question.at("effects");  // what is announced, and faults of the solver
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told.at(0).at("type"), "demand_scale");
  EXPECT_EQ(told.at(0).at("magnitude"), 1.5);
  EXPECT_EQ(told.at(1).at("type"), "solver_fail");
}

TEST(BridgeLines, OpenWithTheCityAsTheScenarioHasIt) {
  YamlMap scenario(
      YamlValue::parse("city: toy-5\nday: \"2024-01-08\"\nseed: 7\n"
                       "stations: [{name: a, region: 4, points: 9}]\n",
                       "a.yaml"));
  const World world = read_world(scenario);
  PlanningSettings settings;
  settings.controller = "mine";
  settings.parameters = {{"reach", 3.0}, {"share", 0.5}, {"mode", "near"}, {"bold", true}};
  const auto opening = nlohmann::json::parse(opening_line(world, settings, "schema: 1\n"));
  EXPECT_EQ(opening.at("controller"), "mine");
  EXPECT_EQ(opening.at("city").at("regions").at(4).at("points"), 9);
  EXPECT_EQ(opening.at("city").at("km").at(1).at(2), world.city.km(1, 2));
  EXPECT_EQ(opening.at("city").at("minutes").at(2).at(1), world.city.minutes(2, 1));
  EXPECT_EQ(opening.at("clock").at("date"), "2024-01-08");
  EXPECT_EQ(opening.at("clock").at("plan_every"), world.clock.plan_every);
  EXPECT_EQ(opening.at("top_up"), false);
  EXPECT_EQ(opening.at("parameters").dump(), R"({"bold":true,"mode":"near","reach":3,"share":0.5})");
  EXPECT_EQ(read_opening(opening.dump()), "schema: 1\n");
}

TEST(BridgeLines, SortTheMoves) {
  const auto moves = read_answer(R"({"moves": [{"from": 1, "to": 0, "count": 1, "errand": "charge"},
                                               {"errand": "rebalance", "from": 2, "to": 1, "count": 1},
                                               {"errand": "rebalance", "from": 2, "to": 0, "count": 1}]})",
                                 "", reports(), city_of(4))
                         .moves;
  ASSERT_EQ(moves.size(), 3U);
  EXPECT_EQ(moves[0].to, 0);
  EXPECT_EQ(moves[1].to, 1);
  EXPECT_EQ(moves[2].errand, Errand::charge);
  EXPECT_TRUE(read_answer(R"({"moves": []})", "", reports(), city_of(4)).moves.empty());
}

TEST(BridgeLines, TopUpWhereTheCityKnowsThat) {
  const std::string stay = move(R"("from": 1, "to": 1, "count": 1, "errand": "charge")");
  EXPECT_EQ(read_answer(stay, "", reports(), city_of(4, true)).moves.size(), 1U);
  expect_refused(stay, "moves[0].to: another region");
  expect_refused(move(R"("from": 1, "to": 1, "count": 1, "errand": "rebalance")"), "moves[0].to: another region", true);
  expect_refused(move(R"("from": 1, "to": 1, "count": 2, "errand": "charge")"), "region 1 has 1 chargeable", true);
  expect_refused(R"({"moves": [{"from": 1, "to": 0, "count": 2, "errand": "rebalance"},
                               {"from": 1, "to": 1, "count": 1, "errand": "charge"}]})",
                 "moves[1].count: region 1 has 0 vacant vehicles left", true);
}

TEST(BridgeLines, BringBothSidesTheSame) {
  Tick tick;
  tick.tick = 4;
  tick.effects = {{.fault = 2, .type = EffectType::solver_starve, .magnitude = 0.1}};
  const PlanRequest heard = read_question(question_line(tick, reports()));
  EXPECT_EQ(heard.tick.tick, 4);
  EXPECT_EQ(heard.tick.effects.at(0).magnitude, 0.1);
  EXPECT_EQ(question_line(heard.tick, heard.reports), question_line(tick, reports()));

  Plan plan{.tick = 4, .moves = {{0, 1, 1, Errand::rebalance}}, .provenance = {}, .origin = {}};
  plan.provenance.controller = "mine";
  plan.provenance.fallback = FallbackLevel::nominal;
  plan.provenance.objective = 0.1;
  plan.provenance.costs = {{"km", 1.0 / 3.0}};
  const Plan back = read_answer(answer_line(plan), "", reports(), city_of(4));
  EXPECT_EQ(answer_line(back), answer_line(plan));
  EXPECT_EQ(back.provenance.costs.at(0).cost, 1.0 / 3.0);
}

TEST(BridgeLines, LetRegionsOfRejectedReportsSendAsEstimated) {
  Plan plan{
      .tick = 4, .moves = {{0, 1, 9, Errand::rebalance}, {3, 1, 2, Errand::charge}}, .provenance = {}, .origin = {}};
  expect_refused(answer_line(plan), "moves[0].count: region 0 has 2 vacant");
  plan.provenance.rejected = {{0, "cannot be"}, {3, "did not come"}};
  EXPECT_EQ(read_answer(answer_line(plan), "", reports(), city_of(4)).moves.size(), 2U);
}

TEST(BridgeLines, RefuseWhatIsNoPlan) {
  expect_refused("", "not valid JSON");
  expect_refused("[]", "an object is expected");
  expect_refused(R"({"moves": {}})", "moves: a list is expected");
  expect_refused(R"({"moves": [], "provenance": {"controller": "mine"}})", "provenance.engine: is missing");
  expect_refused(R"({"moves": [{"from": 0, "to": 1, "count": NaN, "errand": "charge"}]})", "not valid JSON");
  expect_refused(R"({"moves": [7]})", "moves[0]: an object is expected");
  expect_refused(R"({"moves": [], "moves": []})", "`moves` is given twice");
  expect_refused(move(R"("from": 0, "to": 1, "count": 1, "errand": "charge", "km": 3)"), "moves[0].km: is no key here");
  expect_refused(move(R"("from": "0", "to": 1, "count": 1, "errand": "charge")"), "moves[0].from: a number");
  expect_refused(move(R"("from": 0, "to": 1, "count": 0.5, "errand": "charge")"), "moves[0].count: a whole number");
  expect_refused(move(R"("from": 0, "to": 1, "count": 1, "errand": "passenger")"), "moves[0].errand: `rebalance` or");
}

TEST(BridgeLines, RefuseWhatCannotBeDone) {
  expect_refused(move(R"("from": 4, "to": 1, "count": 1, "errand": "charge")"), "moves[0].from: a region from 0 to 3");
  expect_refused(move(R"("from": 3, "to": 1, "count": 1, "errand": "charge")"), "region 3 has 0 low-battery vehicles");
  expect_refused(move(R"("from": 1, "to": 1, "count": 1, "errand": "charge")"), "moves[0].to: another region");
  expect_refused(move(R"("from": 0, "to": 1, "count": 0, "errand": "charge")"), "moves[0].count: region 0 has 1");
  expect_refused(move(R"("from": 0, "to": 1, "count": 3, "errand": "rebalance")"), "region 0 has 2 vacant");
  expect_refused(R"({"moves": [{"from": 0, "to": 1, "count": 2, "errand": "rebalance"},
                               {"from": 0, "to": 2, "count": 1, "errand": "rebalance"}]})",
                 "moves[1].count: region 0 has 0 vacant vehicles left");
  expect_refused(R"({"moves": [{"from": 0, "to": 1, "count": 1, "errand": "rebalance"},
                               {"from": 0, "to": 1, "count": 1, "errand": "rebalance"}]})",
                 "moves: rebalance from 0 to 1 is given twice");
}

}  // namespace
}  // namespace evbal
