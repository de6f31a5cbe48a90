// Controllers of a user's own, built from what evbal's are made of.

#include "coordinator/balancing/controllers.hpp"
#include "tools/samples/random_planning_data.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace evbal {
namespace {

double objective(const Controller& controller, const PlanningData& data, const std::string& engine) {
  const auto certificate = balance(controller, {}, data, {.name = engine}).certificate;
  EXPECT_TRUE(certificate.optimal) << certificate.why_not;
  return certificate.objective;
}

double objective(const std::string& controller, const PlanningData& data, const std::string& engine) {
  return balance(controller, {}, data, {.name = engine}).certificate.objective;
}

TEST(OwnController, PricesShortageByATermOfItsOwn) {
  const auto price = [](int k, const Variables& S, const UncertaintyModel& model, ConvexProgram& program) {
    for (std::size_t i = 0; i < S.size(); ++i) {
      const double r_hat = model.r_hat(static_cast<Eigen::Index>(i), k);
      program.minimise_curve(label("own", k), 30.0 * r_hat, S[i], inverse_power(0.5, 1.0));
    }
  };
  const Controller own{"mine", optimum({.shortage = Shortage::own, .own = price})};
  const auto data = random_planning_data(11, {.regions = 7});
  for (const auto& engine : engine_names()) {
    const double ratio = objective("ratio", data, engine);
    EXPECT_NEAR(objective(own, data, engine), ratio, 2e-6 * ratio) << engine;
  }
}

TEST(OwnController, OfAnOwnTermSeesTheDemandAsItsSwitchSays) {
  const auto data = random_planning_data(12, {.regions = 5});
  double seen = 0.0;
  const auto look = [&](int k, const Variables&, const UncertaintyModel& model, ConvexProgram&) {
    seen += k == 0 ? model.shortage.front().values.front() : 0.0;
  };
  const double spread = std::sqrt(std::min(data.demand.g1, data.demand.g2)) * data.demand.standard_deviation()(0);
  objective({"mine", optimum({.shortage = Shortage::own, .demand = Uncertainty::worst_case, .own = look})}, data,
            "cuts");
  EXPECT_NEAR(seen, data.demand.mean(0) + spread, 1e-12);
}

TEST(OwnController, TakesDemandForWhatItLikes) {
  const Controller more{"more", [](const auto& parameters, PlanningData data, const auto& engine) {
                          data.demand.mean(2) += 20.0;
                          return optimum({})(parameters, data, engine);
                        }};
  auto data = random_planning_data(13, {.regions = 6});
  const double expected = objective(more, data, "cuts");
  EXPECT_NE(objective("nominal", data, "cuts"), expected);
  data.demand.mean(2) += 20.0;
  EXPECT_EQ(objective("nominal", data, "cuts"), expected);
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
  EXPECT_TRUE(result.certificate.optimal);
  EXPECT_EQ(result.certificate.gap, 0.0);
  EXPECT_EQ(result.dispatch.vacant.front().front().amount, 2.0);
  data.state.vacant(1) = std::nan("");
  EXPECT_TRUE(balance(rule, {}, data, {}).certificate.why_not.starts_with("vacant vehicles of region 1"))
      << "is spared data that are none";
}

}  // namespace
}  // namespace evbal
