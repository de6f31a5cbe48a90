#include "tools/records/row_tally.hpp"

#include "tests/folder.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// Reads a table whose column `n` must hold numbers; returns what was dropped, or the refusal.
std::string tally(const std::string& text) {
  const Folder folder;
  TableFormat format;
  format.columns = {"n"};
  RawTable table(folder.write("t.csv", text), format);
  Dropped dropped;
  RowTally rows(table, dropped);
  const std::string folder_name = folder.path().string() + "/";
  std::string said;
  try {
    while (table.next()) {
      RowFault fault = table.fault();
      if (!fault && !table.number(0)) {
        fault = {"`n` is no number", table.text(0)};
      }
      rows.keeps(fault);
    }
    rows.finish();
    said = dropped.report();
  } catch (const Error& error) {
    said = with_report(error, dropped.report()).what();
  }
  for (auto at = said.find(folder_name); at != std::string::npos; at = said.find(folder_name)) {
    said.erase(at, folder_name.size());
  }
  return said;
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) {
    all += text;
  }
  return all;
}

TEST(RowTally, CountsByReasonWithTheFirst) {
  EXPECT_EQ(tally("n,m\n1,2\nx,2\ny,2\n3,\"\n4,5\n6,7,8\n\n"),
            "  dropped, `n` is no number: 2 (first: t.csv:3: `x`)\n"
            "  dropped, more fields than the header names: 1 (first: t.csv:7: `6,7,8`)\n"
            "  dropped, quotes that do not pair: 1 (first: t.csv:5: `3,\"`)\n");
  EXPECT_EQ(tally("n\n1\n"), "");
  EXPECT_EQ(tally("n\n"), "");
}

TEST(RowTally, RefusesATableOfWhichNoRowCanBeRead) {
  EXPECT_EQ(tally("n\nx\ny\n"),
            "t.csv:2: `n` is no number: `x`; none of 2 rows can be read: is the description of this table?\n"
            "  dropped, `n` is no number: 2 (first: t.csv:2: `x`)");
  EXPECT_NE(tally("n\n" + repeated("x\n", 100) + repeated("1\n", 100)).find("none of 100 rows"), std::string::npos);
  EXPECT_EQ(tally("n,m\n" + repeated(",1\n", 200) + "1,1\n"), "  dropped, `n` is no number: 200 (first: t.csv:2: ``)\n")
      << "sorted tables begin with what is blank";
  EXPECT_EQ(tally("n\n1\n" + repeated("x\n", 200)), "  dropped, `n` is no number: 200 (first: t.csv:3: `x`)\n");
}

}  // namespace
}  // namespace evbal
