#include "coordinator/balancing/controllers.hpp"

#include "tests/balancing/random_data.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace evbal {
namespace {

TEST(Controllers, Timing) {
  for (int n : {5, 54}) {
    for (int tau : {1, 2, 3}) {
      for (const auto& name : {"nominal", "robust"}) {
        for (std::uint64_t seed = 1; seed < 6; ++seed) {
          const auto data = random_data(seed, {.regions = n, .tau = tau});
          const auto start = std::clock();
          const auto result = balance(name, {}, data, {});
          const auto& c = result.certificate;
          std::printf("%d %d %s %d it %d  %.3f s obj %.8f gap %.2e viol %.2e %s\n", n, tau, name, c.optimal, c.iterations,
                      double(std::clock() - start) / CLOCKS_PER_SEC, c.objective, c.gap, c.max_violation, c.why_not.c_str());
        }
      }
    }
  }
}

}  // namespace
}  // namespace evbal
