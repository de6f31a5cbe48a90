// Every type of fault in one day: no type is accepted that does nothing.

#include "faults/schedule/fault_types.hpp"

#include "tests/run/evbal/acted.hpp"
#include "tests/run/evbal/command_line.hpp"
#include "tests/run/evbal/random_schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

/// All types one after another, each for an hour and a half.
std::string one_of_each() {
  std::string text = "schema: 1\nseed: 1\nfaults:\n";
  int start = 5 * 60 + 15;
  for (const auto& [type, fields] : fault_fields()) {
    const bool kill = comes_back(type);
    const std::string minute = std::to_string(100 + start % 60).substr(1);
    const std::string hour = std::to_string(100 + start / 60).substr(1);
    text.append("  - {name: ").append(type).append(", type: ").append(type);
    text.append(", start: \"").append(hour).append(":").append(minute).append("\", ");
    text.append(kill ? "restart_after" : "duration").append(": 90min");
    text.append(*fields == '\0' ? "" : ", ").append(fields).append("}\n");
    start += 45;
  }
  return text;
}

TEST(FaultTypes, AreEachSeenToDoSomething) {
  const CommandLine line;
  std::ofstream(line.path() / "all.yaml") << one_of_each();
  const Ended ended =
      line.evbal("run toy.yaml --faults all.yaml --transport inproc --engine cuts --controller robust --out a");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const auto faults = read_faults(line.path() / "a" / "run.sqlite");
  for (const auto& type : fault_type_names()) {
    const auto fault = std::ranges::find(faults, type, &RecordedFault::name);
    ASSERT_NE(fault, faults.end()) << type << " is not in fault_fields()";
    EXPECT_TRUE(acted(*fault)) << type;
  }
}

}  // namespace
}  // namespace evbal
