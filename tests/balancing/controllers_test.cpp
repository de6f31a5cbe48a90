#include "coordinator/balancing/controllers.hpp"

#include "coordinator/balancing/formulation.hpp"
#include "coordinator/balancing/worst_case.hpp"
#include "tests/balancing/solving_controllers.hpp"
#include "tools/samples/random_planning_data.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace evbal {
namespace {

const std::vector<std::string> solving = solving_controllers();

double optimum_of(const std::string& controller, const PlanningData& data, const BalancingParameters& parameters = {}) {
  const auto certificate = balance(controller, parameters, data, {}).certificate;
  EXPECT_TRUE(certificate.optimal()) << controller << ": " << certificate.reason;
  return certificate.objective;
}

class EveryEngine : public ::testing::TestWithParam<std::string> {
 protected:
  EngineSettings engine() const { return {.name = GetParam()}; }
};

INSTANTIATE_TEST_SUITE_P(Controllers, EveryEngine, ::testing::ValuesIn(engine_names()),
                         [](const auto& tested) { return tested.param; });

TEST_P(EveryEngine, FindsACertifiedOptimum) {
  for (const auto& controller : solving) {
    for (const int tau : {1, 2, 4}) {
      const auto result = balance(controller, {}, random_planning_data(1, {.regions = 8, .tau = tau}), engine());
      EXPECT_TRUE(result.certificate.optimal()) << result.certificate.reason;
      EXPECT_LT(result.certificate.max_violation, 1e-6);
      EXPECT_LT(std::abs(result.certificate.gap), 1e-6);
      EXPECT_GT(result.certificate.iterations, 0);
      EXPECT_EQ(std::ssize(result.dispatch.vacant), tau);
      EXPECT_FALSE(result.dispatch.vacant.front().empty());
    }
  }
}

TEST_P(EveryEngine, StaysFeasibleInExtremes) {
  const std::vector<std::pair<std::string, std::function<void(PlanningData&)>>> extremes = {
      {"demand x 10", [](PlanningData& d) { d.demand.mean *= 10.0; }},
      {"no demand", [](PlanningData& d) { d.demand.mean.setZero(); }},
      {"no vehicles",
       [](PlanningData& d) {
         for (auto* stock : {&d.state.vacant, &d.state.occupied, &d.state.low_battery, &d.state.plugged}) {
           stock->setZero();
         }
         d.state.arriving_vacant.setZero();
         d.state.arriving_low_battery.setZero();
       }},
      {"no points", [](PlanningData& d) { d.points.setZero(); }},
      {"points fail under plugged cars", [](PlanningData& d) { d.points.col(0).setZero(); }},
      {"all low",
       [](PlanningData& d) {
         d.state.low_battery += d.state.vacant;
         d.state.vacant.setZero();
       }},
      {"thousands of vehicles", [](PlanningData& d) { d.state.vacant *= 1000.0; }},
      {"a region cut off",
       [](PlanningData& d) {
         d.km.row(2).setConstant(std::numeric_limits<double>::infinity());
         d.km.col(2).setConstant(std::numeric_limits<double>::infinity());
       }},
      {"demand surely what it is forecast to be",
       [](PlanningData& d) {
         d.demand.deviation.setConstant(1e-6);
         d.demand.factors.setZero();
         d.demand.g1 = 0.0;
       }},
      {"covariances of rank one", [](PlanningData& d) { d.completions.deviation.setConstant(1e-6); }},
      {"huge thresholds", [](PlanningData& d) { d.completions.g1 = d.completions.g2 = 1e4; }},
  };
  for (const auto& [what, spoil] : extremes) {
    for (const int tau : {1, 3}) {
      auto data = random_planning_data(5, {.regions = 6, .tau = tau});
      spoil(data);
      for (const auto& controller : controller_names()) {
        const auto certificate = balance(controller, {}, data, engine()).certificate;
        EXPECT_TRUE(certificate.optimal())
            << what << ", " << controller << " over " << tau << " steps: " << certificate.reason;
      }
    }
  }
}

TEST(Controllers, RobustIsNominalWithoutUncertainty) {
  auto data = random_planning_data(2, {.regions = 6});
  const double nominal = optimum_of("nominal", data);
  const double robust = optimum_of("robust", data);
  EXPECT_GT(robust, nominal + 1.0);
  data.demand.g1 = data.completions.g1 = 0.0;
  EXPECT_NEAR(optimum_of("robust", data), nominal, 1e-6 * nominal);
}

// One region, one step: nothing to decide, the whole objective by hand.
TEST(Controllers, PriceAShortageAsTheirFormSays) {
  auto data = random_planning_data(3, {.regions = 1, .tau = 1, .rank = 0, .station_share = 0.0});
  data.state.low_battery.setZero();
  data.state.plugged.setZero();
  data.completions.mean.setZero();
  data.state.vacant << 4.0;
  data.state.waiting << 5.0;
  data.state.dropoffs_due << 3.0;
  data.turnover.same_step_dropoffs << 0.0;
  data.transitions[0].vacant_to_low_battery << 0.0;
  data.transitions[0].vacant_to_vacant << 1.0;
  data.transitions[0].vacant_to_occupied << 0.0;
  data.demand.mean << 6.0;
  data.demand.deviation << 2.0;
  data.demand.g1 = 0.25;
  data.demand.g2 = 1.5;
  data.demand_samples = (Eigen::MatrixXd(1, 3) << 4.0, 6.0, 11.0).finished();
  const BalancingParameters p;
  const double hS = 1.2 * 6.0;  // rho = 6 / 4
  const double lS = 0.8 * 6.0;
  const auto expect = [&](const std::string& controller, double expected) {
    EXPECT_NEAR(optimum_of(controller, data), expected, 2e-6 * std::max(1.0, expected)) << controller;
  };
  expect("nominal", 0.0);
  expect("demand-robust", 0.0);  // 6 +- 1 is within [lS, hS]
  data.demand.g1 = 1.0;
  expect("demand-robust", p.p_shortage * (8.0 - hS) + p.p_surplus * (lS - 4.0));
  expect("moment", p.p_shortage * worst_case_shortage(hS - 6.0, 2.0, 1.0, 1.5).value +
                       p.p_surplus * worst_case_shortage(6.0 - lS, 2.0, 1.0, 1.5).value);
  expect("scenario", p.p_shortage * (11.0 - hS) / 3.0 + p.p_surplus * (lS - 4.0) / 3.0);
  expect("ratio", p.p_ratio * 6.0 / 4.5);
  const double short_of = 6.0 + 0.8 * 5.0 - 4.0 - 0.6 * 3.0;
  const auto certain = solve(formulate(p, data, {.shortage = Shortage::turnover}).program, {}).certificate;
  EXPECT_NEAR(certain.objective, p.p_shortage * short_of, 1e-4);
  const double turnover = optimum_of("turnover", data);
  EXPECT_GT(turnover, p.p_shortage * short_of);
  EXPECT_LT(turnover, p.p_shortage * (short_of + 2.0));
  expect("oracle", turnover);
}

TEST(Controllers, PointsStandInForCompletionsInUtilisationOnly) {
  auto data = random_planning_data(3, {.regions = 4, .tau = 1});
  BalancingParameters points;
  points.supply = Supply::points;
  for (const auto& controller : solving) {
    EXPECT_NE(optimum_of(controller, data, points), optimum_of(controller, data)) << controller;
  }
  const auto options = FormulationOptions{};
  EXPECT_TRUE(uncertainty_model(points, data, options).c_low.isApprox(uncertainty_model({}, data, options).c_low));
  EXPECT_FALSE(uncertainty_model(points, data, options).c_hat.isApprox(uncertainty_model({}, data, options).c_hat));
  data.free_points.mean.setConstant(1e3);
  EXPECT_TRUE(uncertainty_model(points, data, options).c_hat.isApprox(data.points)) << "no more than there are";
}

// With one step, moving vacant and low-battery cars are two problems of one net flow each; both by golden section.
TEST(Controllers, AgreeWithBruteForceOnTwoRegions) {
  const auto golden = [](double low, double high, const auto& f) {
    const double ratio = (std::sqrt(5.0) - 1.0) / 2.0;
    while (high - low > 1e-9) {
      const double a = high - ratio * (high - low);
      const double b = low + ratio * (high - low);
      f(a) < f(b) ? high = b : low = a;
    }
    return f((low + high) / 2.0);
  };
  const BalancingParameters p;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto data = random_planning_data(seed, {.regions = 2, .tau = 1, .rank = 1, .station_share = 1.0});
    const auto& s = data.state;
    for (const bool robust : {false, true}) {
      const double gr = robust ? std::min(data.demand.g1, data.demand.g2) : 0.0;
      const double gc = robust ? std::min(data.completions.g1, data.completions.g2) : 0.0;
      const Eigen::VectorXd vacant = s.vacant + s.arriving_vacant.col(0);
      const Eigen::VectorXd low_battery = s.low_battery + s.arriving_low_battery.col(0);
      const double rho = data.demand.mean.sum() / std::max(1.0, vacant.sum());
      const auto vacant_cost = [&](double x) {
        double cost = std::abs(x) * data.km(0, 1);
        for (int i = 0; i < 2; ++i) {
          const double stay = vacant(i) + (i == 0 ? -x : x);
          const double sigma = data.demand.standard_deviation()(i);
          const double high = data.demand.mean(i) + std::sqrt(gr) * sigma;
          const double low = std::max(0.0, data.demand.mean(i) - std::sqrt(gr) * sigma);
          cost += p.p_shortage * std::max(0.0, high - rho * (1.0 + p.eta) * stay);
          cost += p.p_surplus * std::max(0.0, rho * (1.0 - p.eta) * stay - low);
        }
        return cost;
      };
      const auto low_battery_cost = [&](double y) {
        double cost = p.beta * std::abs(y) * data.km(0, 1);
        Eigen::Vector2d z;
        for (int i = 0; i < 2; ++i) {
          const double there = low_battery(i) + (i == 0 ? -y : y);
          const double sigma = data.completions.standard_deviation()(i);
          const double c_low = std::max(0.0, data.completions.mean(i) - std::sqrt(gc) * sigma);
          const double released = std::min(s.plugged(i), c_low);
          const double plugs = std::min(there, data.points(i, 0) - s.plugged(i) + released);
          const double c_hat =
              std::min(data.completions.mean(i), data.points(i, 0) * data.step_minutes / data.mean_session_minutes);
          z(i) = std::pow(there + p.eps, -p.a);
          cost += p.omega * (there - plugs) + p.pi_e * (c_low - released) + p.theta_0 / p.a * c_hat * z(i);
        }
        const Eigen::Matrix2d sigma =
            Eigen::Matrix2d(data.completions.deviation.array().square().matrix().asDiagonal()) +
            data.completions.factors * data.completions.factors.transpose();
        return cost + p.theta_0 / p.a * std::sqrt(gc * z.dot(sigma * z));
      };
      const double expected = golden(-s.vacant(1), s.vacant(0), vacant_cost) +
                              golden(-s.low_battery(1), s.low_battery(0), low_battery_cost);
      EXPECT_NEAR(optimum_of(robust ? "robust" : "nominal", data), expected, 2e-6 * expected) << "seed " << seed;
    }
  }
}

RC_GTEST_PROP(Controllers, NeverSendMoreThanThereIsAndLoseNobody, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const int regions = *rc::gen::inRange(1, 6);
  const auto data = random_planning_data(seed, {.regions = regions, .tau = 3});
  const auto options =
      *rc::gen::element(FormulationOptions{Shortage::band, Uncertainty::worst_case, Uncertainty::worst_case},
                        FormulationOptions{Shortage::moments, Uncertainty::worst_case, Uncertainty::worst_case},
                        FormulationOptions{Shortage::band, Uncertainty::samples, Uncertainty::mean},
                        FormulationOptions{Shortage::ratio, Uncertainty::mean, Uncertainty::mean},
                        FormulationOptions{Shortage::turnover, Uncertainty::counts, Uncertainty::mean});
  const auto formulation = formulate({}, data, options);
  const auto solution = solve(formulation.program, {});
  RC_ASSERT(solution.certificate.optimal());
  Eigen::VectorXd left = data.state.vacant;
  const auto dispatch = dispatch_at(formulation, solution.x);
  for (const auto& flow : dispatch.vacant.front()) {
    left(flow.from) -= flow.amount;
  }
  RC_ASSERT(left.minCoeff() >= -1e-6);

  // V+O+L+B at the second step is the fleet and what came off the road.
  double second = 0.0;
  const auto& [V, O, L, B] = formulation.stock[1];
  for (const auto* expressions : {&V, &O, &L, &B}) {
    for (const auto& expression : *expressions) {
      second += value_of(expression, solution.x);
    }
  }
  const auto& s = data.state;
  const double first = s.vacant.sum() + s.occupied.sum() + s.low_battery.sum() + s.plugged.sum() +
                       s.arriving_vacant.col(0).sum() + s.arriving_low_battery.col(0).sum();
  RC_ASSERT(std::abs(first - second) < 1e-6 * std::max(1.0, first));
}

TEST(Controllers, RefuseByName) {
  const auto refusal = [](const std::function<void(PlanningData&, BalancingParameters&)>& spoil) {
    auto data = random_planning_data(1, {.regions = 4});
    BalancingParameters parameters;
    spoil(data, parameters);
    const auto certificate = balance("robust", parameters, data, {}).certificate;
    EXPECT_FALSE(certificate.optimal());
    return certificate.reason;
  };
  const double nan = std::nan("");
  EXPECT_TRUE(
      refusal([&](auto& d, auto&) { d.state.vacant(3) = nan; }).starts_with("vacant vehicles of region 3: nan"));
  EXPECT_TRUE(refusal([](auto& d, auto&) { d.state.plugged(0) = -1.0; }).starts_with("plugged vehicles of region 0"));
  EXPECT_TRUE(
      refusal([&](auto& d, auto&) { d.demand.factors(5, 1) = nan; }).starts_with("demand, factor 1 of region 1"));
  EXPECT_TRUE(refusal([](auto& d, auto&) { d.completions.deviation(2) = 0.0; }).starts_with("completions, deviation"));
  EXPECT_TRUE(refusal([](auto& d, auto&) { d.completions.g2 = -0.1; }).starts_with("completions, threshold g2"));
  EXPECT_TRUE(refusal([](auto& d, auto&) {
                d.transitions[1].vacant_to_vacant(2, 2) += 0.01;
              }).starts_with("transitions of vacant, step 1, row sum of region 2"));
  EXPECT_TRUE(refusal([&](auto& d, auto&) {
                d.demand_samples(6, 3) = nan;
              }).starts_with("demand, step 1, of region 2, sample 3: nan"));
  EXPECT_TRUE(refusal([](auto& d, auto&) {
                d.state.dropoffs_due(1, 0) = -1.0;
              }).starts_with("drop-offs due of region 1, step 0"));
  EXPECT_TRUE(refusal([](auto& d, auto&) { d.demand.mean(1) = 1e7; }).starts_with("demand, mean of region 1"));
  EXPECT_TRUE(
      refusal([](auto& d, auto&) { d.turnover.demand.linear.front() = -1.0; }).starts_with("variance of demand"));
  EXPECT_TRUE(refusal([](auto& d, auto&) { d.points(1, 1) = -2.0; }).starts_with("points of region 1, step 1"));
  EXPECT_TRUE(refusal([](auto&, auto& p) { p.a = 0.0; }).starts_with("parameter a"));
}

TEST_P(EveryEngine, RefusesACovarianceThatIsNone) {
  const auto data = random_planning_data(1, {.regions = 4});
  auto not_a_number = data;
  not_a_number.completions.factors(2, 0) = std::nan("");
  auto singular = data;
  singular.demand.deviation(1) = 0.0;
  for (const auto& controller : controller_names()) {
    for (const auto& [spoilt, datum] : {std::pair(not_a_number, "completions, factor 0 of region 2"),
                                        std::pair(singular, "demand, deviation of region 1")}) {
      const auto certificate = balance(controller, {}, spoilt, engine()).certificate;
      EXPECT_FALSE(certificate.optimal()) << controller;
      EXPECT_TRUE(certificate.reason.starts_with(datum)) << certificate.reason;
    }
  }
}

TEST(Controllers, SayWhyASolveFailed) {
  const auto data = random_planning_data(1, {.regions = 5});
  const auto result = balance("robust", {}, data, {.name = "ipopt", .max_iterations = 3});
  EXPECT_FALSE(result.certificate.optimal());
  EXPECT_EQ(result.certificate.reason, "no optimum within 3 iterations");
  EXPECT_TRUE(result.dispatch.vacant.empty());
}

TEST_P(EveryEngine, SolvesTheSameTwice) {
  const auto data = random_planning_data(4, {.regions = 10});
  const auto once = balance("robust", {}, data, engine());
  const auto twice = balance("robust", {}, data, engine());
  EXPECT_EQ(once.certificate.objective, twice.certificate.objective);
  EXPECT_EQ(once.certificate.lower_bound, twice.certificate.lower_bound);
}

// sup E[h'xi] = h'mu + sqrt(g) || Sigma^(1/2) h ||: no mean within the ellipsoid does worse, and one does as badly.
TEST(WorstCase, ClosedFormIsTheSupremum) {
  const auto data = random_planning_data(6, {.regions = 3, .tau = 2, .rank = 2});
  const auto& set = data.completions;
  const Eigen::VectorXd h = Eigen::VectorXd::LinSpaced(6, -1.0, 2.0);
  const NormTerm norm{1.0, {0, 1, 2, 3, 4, 5}, set.deviation, set.factors};
  const double supremum = std::sqrt(set.g1) * norm.norm(h);
  const Eigen::MatrixXd sigma =
      Eigen::MatrixXd(set.deviation.array().square().matrix().asDiagonal()) + set.factors * set.factors.transpose();
  const Eigen::MatrixXd root = sigma.llt().matrixL();
  for (int draw = 0; draw < 2000; ++draw) {
    const Eigen::VectorXd direction = Eigen::VectorXd::NullaryExpr(
        6, [draw](Eigen::Index i) { return std::sin(1.0 + 7.3 * draw + 1.7 * static_cast<double>(i) * draw); });
    const Eigen::VectorXd delta = std::sqrt(set.g1) * (root * direction.normalized());
    EXPECT_LE(h.dot(delta), supremum + 1e-12);
  }
  const Eigen::VectorXd worst = std::sqrt(set.g1) * sigma * h / norm.norm(h);
  EXPECT_NEAR(worst.dot(sigma.llt().solve(worst)), set.g1, 1e-12);
  EXPECT_NEAR(h.dot(worst), supremum, 1e-12);
}

}  // namespace
}  // namespace evbal
