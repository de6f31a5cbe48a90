#include "common/pin.hpp"

#include <gtest/gtest.h>

/// What is computed in this process is compared with what the run's processes compute.
int main(int argc, char** argv) {
  evbal::pin_arithmetic(argv);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
