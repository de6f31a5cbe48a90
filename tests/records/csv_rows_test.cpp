#include "tools/records/csv_rows.hpp"

#include "common/table_text.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace evbal {
namespace {

using Table = std::vector<std::vector<std::string>>;

/// The rows of a table; one with a stray quote is {"stray", LINE}.
Table rows_of(const std::string& text, char separator = ',') {
  const Folder folder;
  CsvRows rows(folder.write("t.csv", text), separator);
  Table all;
  while (rows.next()) {
    all.push_back(rows.stray_quote() ? std::vector<std::string>{"stray", std::to_string(rows.line())}
                                     : std::vector<std::string>(rows.fields().begin(), rows.fields().end()));
  }
  return all;
}

TEST(CsvRows, KeepLineBreaksAndSeparatorsWithinQuotes) {
  EXPECT_EQ(rows_of("a,b\n\"1\n\n,2\", \"say \"\"3\"\"\" \n4,5\n"),
            (Table{{"a", "b"}, {"1\n\n,2", "say \"3\""}, {"4", "5"}}));
  EXPECT_EQ(rows_of("a;b\r\n\"1\r\n2\";\"3\"\r\n", ';'), (Table{{"a", "b"}, {"1\n2", "3"}}));
  EXPECT_EQ(rows_of("a\tb\n\t \"1\t2\"\n", '\t'), (Table{{"a", "b"}, {"", "1\t2"}}));
  EXPECT_EQ(rows_of("a b\n \"1 2\"  3 \n", ' '), (Table{{"a", "b"}, {"1 2", "3"}}));
}

TEST(CsvRows, TakeAQuoteWithinAFieldAsItIs) {
  EXPECT_EQ(rows_of("a,b\n5\" pipe,2\n"), (Table{{"a", "b"}, {"5\" pipe", "2"}}));
}

TEST(CsvRows, LoseOneLineByAStrayQuote) {
  EXPECT_EQ(rows_of("a,b\n1,\"2\n3,4\n5,6\n"), (Table{{"a", "b"}, {"stray", "2"}, {"3", "4"}, {"5", "6"}}))
      << "never closed";
  EXPECT_EQ(rows_of("a,b\n1,\"2\n3,4\n5,\"6\"\n7,8\n"),
            (Table{{"a", "b"}, {"stray", "2"}, {"3", "4"}, {"5", "6"}, {"7", "8"}}))
      << "closed by the quote of a later row";
  EXPECT_EQ(rows_of("a,b\n\"1,2\n3,4\n5\",6,7\n"), (Table{{"a", "b"}, {"stray", "2"}, {"3", "4"}, {"5\"", "6", "7"}}))
      << "closed at a field's end, but with other columns";
  EXPECT_EQ(rows_of("a,b\n\"1\"x,2\n3,4\n"), (Table{{"a", "b"}, {"stray", "2"}, {"3", "4"}}));
}

TEST(CsvRows, CountLinesThatStandWithinRows) {
  const Folder folder;
  CsvRows rows(folder.write("t.csv", "a,b\n\"1\n2\",3\n\n4,5\n"), ',');
  std::vector<int> lines;
  while (rows.next()) {
    lines.push_back(rows.line());
  }
  EXPECT_EQ(lines, (std::vector<int>{1, 2, 5}));
}

TEST(CsvRows, TakeFilesOfAnyProgram) {
  const Table expected{{"a", "b"}, {"1", "2"}};
  EXPECT_EQ(rows_of("a,b\r1,2\r"), expected) << "old Macintosh";
  EXPECT_EQ(rows_of("\xEF\xBB\xBF\"a\",b\r\n1,2"), expected) << "Excel";
  EXPECT_EQ(rows_of("a"), (Table{{"a"}})) << "one line without end";
  EXPECT_EQ(rows_of("a,b\r\n1,2\r"), expected) << "broken off between CR and LF";
  const std::string wide(100'000, 'x');
  EXPECT_EQ(rows_of(wide + ",b\r1,2\r"), (Table{{wide, "b"}, {"1", "2"}})) << "a first line that is long";
  EXPECT_EQ(rows_of("\xEF\xBB\xBF"), Table{});
  EXPECT_EQ(rows_of(""), Table{});
  EXPECT_THROW(rows_of(std::string("\xFF\xFE"
                                   "a\0,\0",
                                   6)),
               Error)
      << "UTF-16";
}

TEST(CsvRows, TakeFieldsOfAnyLength) {
  const std::string wide(200'000, 'x');
  EXPECT_EQ(rows_of("a,b\n1,\"" + wide + "\"\n" + wide + ",2\n"), (Table{{"a", "b"}, {"1", wide}, {wide, "2"}}));
}

TEST(CsvRows, LookForTheOtherQuoteWithinAMebibyte) {
  const std::string lines(1 << 19, '\n');
  EXPECT_EQ(rows_of("a\n\"1" + lines + "2\"\n"), (Table{{"a"}, {"1" + lines + "2"}}));
  EXPECT_EQ(rows_of("a\n\"1" + lines + lines + lines + "2\"\n3\n"), (Table{{"a"}, {"stray", "2"}, {"2\""}, {"3"}}));
}

RC_GTEST_PROP(CsvRows, ReadBackWhatIsWritten, ()) {
  const auto cell = rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab\",\n")));
  const auto columns = *rc::gen::inRange<std::size_t>(2, 5);
  const auto table = *rc::gen::container<Table>(rc::gen::container<std::vector<std::string>>(columns, cell));
  std::string text = csv_row(std::vector<std::string>(columns, "x"));
  for (const auto& row : table) {
    text += csv_row(row);
  }
  auto read = rows_of(text);
  RC_ASSERT(!read.empty());
  read.erase(read.begin());
  RC_ASSERT(read == table);
}

}  // namespace
}  // namespace evbal
