// Controllers of a user's own, built from what evbal's are made of.

#include "common/files.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "tests/support/source_folder.hpp"
#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

double objective_of(const Controller& controller, const PlanningData& data, const std::string& engine) {
  const auto certificate = balance(controller, {}, data, {.name = engine}).certificate;
  EXPECT_TRUE(certificate.optimal()) << certificate.reason;
  return certificate.objective;
}

double objective_of(const std::string& controller, const PlanningData& data, const std::string& engine) {
  return balance(controller, {}, data, {.name = engine}).certificate.objective;
}

TEST(OwnController, PricesShortageByATermOfItsOwn) {
  const auto price = [](int k, const Variables& S, const UncertaintyModel& model, ConvexProgram& program) {
    for (int i = 0; i < S.size(); ++i) {
      program.minimise_curve("own", 30.0 * model.r_hat(i, k), S[i], inverse_power(0.5, 1.0), {"own", k, i});
    }
  };
  const Controller own{"mine", optimum({.shortage = Shortage::own, .own = price})};
  const auto data = random_planning_data(11, {.regions = 7});
  for (const auto& engine : engine_names()) {
    const double ratio = objective_of("ratio", data, engine);
    EXPECT_NEAR(objective_of(own, data, engine), ratio, 2e-6 * ratio) << engine;
  }
}

TEST(OwnController, OfAnOwnTermSeesTheDemandAsItsOptionSays) {
  const auto data = random_planning_data(12, {.regions = 5});
  double seen = 0.0;
  const auto look = [&](int k, const Variables&, const UncertaintyModel& model, ConvexProgram&) {
    seen += k == 0 ? model.shortage.front().values.front() : 0.0;
  };
  const double spread = std::sqrt(std::min(data.demand.g1, data.demand.g2)) * data.demand.standard_deviation()(0);
  objective_of({"mine", optimum({.shortage = Shortage::own, .demand = Uncertainty::worst_case, .own = look})}, data,
               "cuts");
  EXPECT_NEAR(seen, data.demand.mean(0) + spread, 1e-12);
}

TEST(OwnController, TakesDemandForWhatItLikes) {
  const Controller more{"more", [](const auto& parameters, PlanningData data, const auto& engine) {
                          data.demand.mean(2) += 20.0;
                          return optimum({})(parameters, data, engine);
                        }};
  auto data = random_planning_data(13, {.regions = 6});
  const double expected = objective_of(more, data, "cuts");
  EXPECT_NE(objective_of("nominal", data, "cuts"), expected);
  data.demand.mean(2) += 20.0;
  EXPECT_EQ(objective_of("nominal", data, "cuts"), expected);
}

TEST(OwnController, PlansByARule) {
  const Controller rule{"rule", [](const auto&, const PlanningData& data, const auto&) {
                          const auto steps = static_cast<std::size_t>(data.points.cols());
                          Dispatch dispatch{.vacant = std::vector<std::vector<Flow>>(steps), .low_battery = {}};
                          dispatch.vacant.front() = {{0, 1, 2.0}};
                          return by_rule(dispatch);
                        }};
  auto data = random_planning_data(14, {.regions = 3});
  const auto result = balance(rule, {}, data, {});
  EXPECT_TRUE(result.certificate.optimal());
  EXPECT_EQ(result.certificate.gap, 0.0);
  EXPECT_EQ(result.dispatch.vacant.front().front().amount, 2.0);
  data.state.vacant(1) = std::nan("");
  EXPECT_TRUE(balance(rule, {}, data, {}).certificate.reason.starts_with("vacant vehicles of region 1"))
      << "is spared data that are none";
}

// A term of variables and rows of its own, as docs/your-own-controller.md writes one: the shortage at  r_hat.
TEST(OwnController, WritesVariablesAndRows) {
  const auto price = [](int k, const Variables& S, const UncertaintyModel& model, ConvexProgram& program) {
    for (int i = 0; i < S.size(); ++i) {
      const Variable missing = program.add_variable({"missing", k, i});
      program.add(missing >= model.r_hat(i, k) - S[i], {"missing", k, i});
      program.minimise("shortage", 12.0 * missing);
    }
  };
  const Controller own{"mine", optimum({.shortage = Shortage::own, .own = price})};
  const auto data = random_planning_data(15, {.regions = 1, .tau = 1});
  const auto result = balance(own, {}, data, {.name = "cuts"});
  const auto shortage = std::ranges::find(result.cost, "shortage", &CostTerm::name);
  ASSERT_NE(shortage, result.cost.end());
  EXPECT_NEAR(shortage->cost, 12.0 * std::max(0.0, data.demand.mean(0) - data.state.vacant(0)), 1e-6);
}

TEST(OwnController, IsShownOnItsPageAsItStandsInTheExample) {
  const auto page = text_of_file(test::in_source("docs/your-own-controller.md"));
  const auto example = text_of_file(test::in_source("examples/own-controllers/my_coordinator.cpp"));
  const std::string open = "```cpp\n";
  int blocks = 0;
  for (auto at = page.find(open); at != std::string::npos; at = page.find(open, at + 1), ++blocks) {
    const auto start = at + open.size();
    const auto block = page.substr(start, page.find("```", start) - start);
    EXPECT_NE(example.find(block), std::string::npos) << block;
  }
  EXPECT_EQ(blocks, 2);
}

}  // namespace
}  // namespace evbal
