#include "common/table_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace evbal {
namespace {

using Cells = std::vector<std::string>;

TEST(TableText, QuotesWhatCsvMustQuote) {
  EXPECT_EQ(csv_row({"a", "b, c", "say \"d\"", "", "# e|f"}), "a,\"b, c\",\"say \"\"d\"\"\",,# e|f\n");
  EXPECT_EQ(csv_cell("two\nlines"), "\"two\nlines\"");
}

TEST(TableText, SplitsRows) {
  EXPECT_EQ(split_csv("a,\"b, c\",,\"say \"\"d\"\"\""), (Cells{"a", "b, c", "", "say \"d\""}));
  EXPECT_EQ(split_csv(""), Cells{""});
  EXPECT_EQ(split_csv("a;b,c", ';'), (Cells{"a", "b,c"}));
  Cells cells{"of", "the", "row", "before"};
  split_csv("x,y", ',', cells);
  EXPECT_EQ(cells, (Cells{"x", "y"}));
}

RC_GTEST_PROP(TableText, GivesCellsBack, ()) {
  const auto text = rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab,\"; |")));
  const auto cells = *rc::gen::nonEmpty(rc::gen::container<Cells>(text));
  std::string row = csv_row(cells);
  row.pop_back();
  RC_ASSERT(split_csv(row) == cells);
}

TEST(TableText, KeepsMarkdownCellsInTheirTable) {
  EXPECT_EQ(markdown_cell("a | b"), "a \\| b");
  EXPECT_EQ(markdown_cell("# p_lost *x* [y] `z`\nw"), "\\# p\\_lost \\*x\\* \\[y\\] \\`z\\` w");
}

}  // namespace
}  // namespace evbal
