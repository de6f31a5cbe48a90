#include "tools/fit/transition_table.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

std::vector<Region> regions() {
  return {{"west, old", {}, {}}, {"east", {}, {}}};
}

std::vector<TransitionCounts> counts() {
  std::vector<TransitionCounts> all(transition_periods().size(), TransitionCounts(2));
  all[1].vacant << 10, 3, 80, 0, 5, 2, 1, 1, 1, 1, 1, 1;
  all[4].occupied << 0, 70, 30, 20, 1, 0, 0, 0;
  return all;
}

class TransitionTable : public testing::Test {
 protected:
  TransitionTable() : report_(write_transitions(counts(), regions(), file())), text_(text_of(file())) {}

  std::filesystem::path file() const { return folder_.path() / "transitions.csv"; }

  void expect_refused(const std::string& from, const std::string& to, const std::string& reason) {
    std::string text = text_;
    text.replace(text.find(from), from.size(), to);
    folder_.write("transitions.csv", text);
    try {
      read_transitions(file(), regions());
      FAIL() << "was accepted, expected: " << reason;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }

  Folder folder_;
  std::string report_;
  std::string text_;
};

TEST_F(TransitionTable, IsReadAsItWasWritten) {
  EXPECT_NE(report_.find("transitions counted: 227\n"), std::string::npos) << report_;
  EXPECT_NE(report_.find("towards the day's mean: 22 of 24"), std::string::npos) << report_;
  const std::vector<Period> written = periods_of(counts());
  const std::vector<Period> read = read_transitions(file(), regions());
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t p = 0; p < read.size(); ++p) {
    EXPECT_EQ(read[p].start, written[p].start);
    EXPECT_EQ(read[p].transitions.vacant_to_vacant, written[p].transitions.vacant_to_vacant);
    EXPECT_EQ(read[p].transitions.vacant_to_low_battery, written[p].transitions.vacant_to_low_battery);
    EXPECT_EQ(read[p].transitions.vacant_to_occupied, written[p].transitions.vacant_to_occupied);
    EXPECT_EQ(read[p].transitions.occupied_to_vacant, written[p].transitions.occupied_to_vacant);
    EXPECT_EQ(read[p].transitions.occupied_to_occupied, written[p].transitions.occupied_to_occupied);
  }
}

TEST_F(TransitionTable, IsRefusedIfItIsNotOfTheCity) {
  expect_refused("\"west, old\"", "west", "transitions.csv:2: the city has no region `west`");
  expect_refused("05:00", "06:00", "transitions.csv:2: no period begins at `06:00`");
  expect_refused("vacant", "parked", "`parked` becomes `vacant`; expected vacant or occupied");
  const std::string row = text_.substr(text_.find("05:00,east,occupied"));
  expect_refused(row.substr(0, row.find('\n') + 1), "", "from 05:00, shares of region `east`, occupied, sum to 0.");
}

}  // namespace
}  // namespace evbal
