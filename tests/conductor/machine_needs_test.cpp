#include "experiments/conductor/machine_needs.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(MachineNeeds, HundredsOfProcessesAreToldWhichBuffersAreTooSmall) {
  constexpr int usual = 212'992;
  EXPECT_EQ(buffer_complaint(usual, 57), "");
  EXPECT_EQ(buffer_complaint(usual, 250), "");
  EXPECT_EQ(buffer_complaint(4 * 1024 * 1024, 1003), "");
  const std::string complaint = buffer_complaint(usual, 494);
  EXPECT_NE(complaint.find("208 KiB"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("494 processes"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("net.core.rmem_max=4194304"), std::string::npos) << complaint;
}

}  // namespace
}  // namespace evbal
