#include "common/contract.hpp"

#include "common/random.hpp"
#include "coordinator/balancing/discrete_distribution.hpp"
#include "coordinator/convex/convex_function.hpp"
#include "coordinator/convex/convex_program.hpp"
#include "coordinator/convex/engine.hpp"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <memory>

namespace evbal {
namespace {

TEST(ContractDeathTest, ABrokenOneSaysWhatWasExpectedAndWhere) {
  const int cars = 3;
  EXPECT_DEATH(EVBAL_EXPECT(cars > 4, "more than four cars"),
               "contract_test.cpp:[0-9]+: contract broken: expected more than four cars .cars > 4.");
}

TEST(Contract, OneThatHoldsIsNoStatementOfItsOwn) {
  int evaluated = 0;
  EVBAL_EXPECT(++evaluated == 1, "to be evaluated once");
  EXPECT_EQ(evaluated, 1);
}

// One function of each room that users link, as it is built, which is mostly with NDEBUG.
TEST(ContractDeathTest, ContractsOfLibrariesAreArmedInEveryBuild) {
  EXPECT_DEATH(RandomStream(1, Purpose::demand_sample, {}).below(0), "contract broken");
  EXPECT_DEATH(negative_binomial(-1.0, 1.0), "contract broken");
  EXPECT_DEATH(empirical({}), "contract broken");
  EXPECT_DEATH(inverse_power(0.0, 1.0), "contract broken");
  EXPECT_DEATH(ConvexProgram().add_block("x", 1, 1.0, 0.0), "contract broken");
  EXPECT_DEATH(solve(ConvexProgram(), {.name = "simplex"}), "contract broken");
}

}  // namespace
}  // namespace evbal
