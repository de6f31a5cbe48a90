#include "common/error.hpp"
#include "coordinator/balancing/worst_case.hpp"
#include "tools/verify/csdp.hpp"
#include "tools/verify/inner_problem.hpp"
#include "tools/verify/moment_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

namespace evbal {
namespace {

MomentSet set_of_three(double g1, double g2) {
  MomentSet set;
  set.mean = Eigen::Vector3d(1.0, 4.0, -2.0);
  set.deviation = Eigen::Vector3d(0.5, 1.0, 1.5);
  set.factors = Eigen::Vector3d(1.0, -0.5, 0.3);
  set.g1 = g1;
  set.g2 = g2;
  return set;
}

TEST(Verify, TheTheoremsInnerProblemIsItsClosedForm) {
  const Eigen::Vector3d h(1.0, -2.0, 0.5);
  for (const auto& [g1, g2] : {std::pair{0.3, 1.5}, {1.5, 0.3}}) {
    const auto set = set_of_three(g1, g2);
    const auto solution = solve_with_csdp(inner_problem(set, h));
    ASSERT_EQ(solution.size(), 2U + 3U + 6U);
    EXPECT_NEAR(solution[0] + solution[1], closed_form(set, h), 1e-5);
  }
}

TEST(Verify, SaysWhereCsdpComesFrom) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  try {
    solve_with_csdp("");
    ADD_FAILURE() << "found csdp nowhere";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "csdp is not installed; Debian's package coinor-csdp has it");
  }
  setenv("PATH", path.c_str(), 1);
}

TEST(Verify, ClosedFormByHand) {
  const Eigen::Vector3d h(0.0, 0.0, 2.0);
  EXPECT_DOUBLE_EQ(closed_form(set_of_three(0.25, 1.0), h), -4.0 + 0.5 * 2.0 * std::sqrt(1.5 * 1.5 + 0.3 * 0.3));
}

TEST(Verify, MomentProblemOfKnownOptimum) {
  EXPECT_NEAR(moment_problem(0.0, 2.0, 0.25, 1.0), 1.5, 1e-8);
  EXPECT_NEAR(moment_problem(0.0, 2.0, 0.0, 1.0), 1.0, 1e-8);  // Scarf's bound
  EXPECT_NEAR(moment_problem(3.0, 2.0, 0.25, 1.0), worst_case_shortage(3.0, 2.0, 0.25, 1.0).value, 1e-8);
}

}  // namespace
}  // namespace evbal
