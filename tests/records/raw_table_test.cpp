#include "tools/records/raw_table.hpp"

#include "tests/folder.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// The rows of a table of two columns as "first|second", or "torn".
std::vector<std::string> rows(const std::string& yaml, const std::string& table) {
  const Folder folder;
  YamlMap map(YamlValue::parse(yaml, "format.yaml"));
  TableFormat format = read_table_format(map);
  add_column(format, map.require("first"));
  add_column(format, map.require("second"));
  RawTable raw(folder.write("table.csv", table), format);
  std::vector<std::string> all;
  while (raw.next()) {
    all.push_back(raw.whole() ? std::string(raw.text(0)) + "|" + std::string(raw.text(1)) : "torn");
  }
  return all;
}

using Rows = std::vector<std::string>;

TEST(RawTable, FindsColumnsByName) {
  EXPECT_EQ(rows("first: b\nsecond: a\n", "\xEF\xBB\xBFx,a,b\r\n1, 2 ,3\r\n\n4,5\n,,\n\"6\",\"7,\"\"7\",8"),
            (Rows{"3|2", "torn", "|", "8|7,\"7"}));
}

TEST(RawTable, FindsColumnsByNumber) {
  EXPECT_EQ(rows("separator: space\nheader: false\nfirst: 1\nsecond: 3\n", "a b c\n a \t b  c d\nlone\n"),
            (Rows{"a|c", "a|c", "torn"}));
  EXPECT_EQ(rows("separator: tab\nheader: false\nfirst: 2\nsecond: 1\n", "a\tb\n\tb\n"), (Rows{"b|a", "b|"}));
  EXPECT_EQ(rows("separator: semicolon\nfirst: a\nsecond: b\n", "a;b\n1,5;2\n"), (Rows{"1,5|2"}));
}

TEST(RawTable, RefusesATableWithoutTheColumns) {
  EXPECT_THROW(rows("first: a\nsecond: c\n", "a,b\n1,2\n"), Error);
  EXPECT_THROW(rows("first: a\nsecond: b\n", ""), Error);
  EXPECT_THROW(rows("header: false\nfirst: 0\nsecond: 1\n", "1,2\n"), Error);
  EXPECT_THROW(rows("header: false\nfirst: a\nsecond: b\n", "1,2\n"), Error);
}

/// What the reader says of a table.
std::string refusal(const std::string& yaml, const std::string& table) {
  try {
    rows(yaml, table);
  } catch (const Error& error) {
    return error.what();
  }
  return "was accepted";
}

TEST(RawTable, SaysWhereTheHeaderIs) {
  const std::string table = "Trips of May\n\nfrom the \"office\n\na,b\n1,2\n";
  const std::string said = refusal("first: a\nsecond: b\n", table);
  EXPECT_NE(said.find("table.csv:1: has no column `a`; it has `Trips of May`"), std::string::npos) << said;
  EXPECT_NE(said.find("named in line 5: give `skip_rows`"), std::string::npos) << said;
  EXPECT_EQ(rows("skip_rows: 4\nfirst: a\nsecond: b\n", table), Rows{"1|2"});
  EXPECT_EQ(rows("skip_rows: 5\nheader: false\nfirst: 1\nsecond: 2\n", table), Rows{"1|2"});
  EXPECT_NE(refusal("first: a\nsecond: b\n", "a;b\n1;2\n").find("it has `a;b`; what is its `separator`?"),
            std::string::npos);
}

TEST(RawTable, RefusesAHeaderWithAStrayQuote) {
  const std::string said = refusal("first: a\nsecond: b\n", "a,\"b\n1,2\n3,4\n");
  EXPECT_NE(said.find("table.csv:1: has no column `a`; it has `a,\"b`; its quotes do not pair"), std::string::npos)
      << said;
}

TEST(RawTable, ShowsAHeaderOfAnyBytes) {
  const std::string said = refusal("first: alpha\nsecond: b\n", std::string("\0alpha,b\n1,2\n", 13));
  EXPECT_NE(said.find("table.csv:1: has no column `alpha`; it has `?alpha, b`"), std::string::npos) << said;
}

TEST(RawTable, RefusesAColumnThatIsNamedTwice) {
  EXPECT_NE(refusal("first: a\nsecond: b\n", "a,b,a\n1,2,3\n").find("names the column `a` twice"), std::string::npos);
  EXPECT_EQ(rows("first: a\nsecond: b\n", "a,b,c,c\n1,2,3,4\n"), Rows{"1|2"}) << "others may be";
}

TEST(RawTable, DropsRowsThatDoNotFitTheHeader) {
  EXPECT_EQ(rows("first: a\nsecond: b\n", "a,b\n1,2,\n1,2, ,\n1,x,2\n1\n"), (Rows{"1|2", "1|2", "torn", "torn"}));
  EXPECT_EQ(rows("first: a\nsecond: b\n", std::string("a,b\n1,2\n1,\0\n", 12)), (Rows{"1|2", "torn"}));
}

/// The only field of a table as a number and as a whole number, "-" for none.
std::string numbers(const std::string& yaml, const std::string& field) {
  const Folder folder;
  YamlMap map(YamlValue::parse("{separator: semicolon, " + yaml + ", n: n}", "format.yaml"));
  TableFormat format = read_table_format(map);
  add_column(format, map.require("n"));
  RawTable raw(folder.write("table.csv", "n\n" + field + "\n"), format);
  raw.next();
  const auto number = raw.number(0);
  const auto whole = raw.integer(0);
  return (number ? std::to_string(*number) : "-") + " " + (whole ? std::to_string(*whole) : "-");
}

TEST(RawTable, ReadsNumbersAsTheFormatSays) {
  EXPECT_EQ(numbers("decimal: comma", "52,25"), "52.250000 -");
  EXPECT_EQ(numbers("decimal: comma", "2,0"), "2.000000 2");
  EXPECT_EQ(numbers("decimal: comma", "1.234"), "- -") << "a point that groups thousands";
  EXPECT_EQ(numbers("decimal: point", "52,25"), "- -");
  EXPECT_EQ(numbers("decimal: point", "3.0"), "3.000000 3");
  EXPECT_EQ(numbers("decimal: point", "9007199254740993"), "9007199254740992.000000 9007199254740993");
  EXPECT_EQ(numbers("decimal: point", "nan"), "- -");
  EXPECT_EQ(numbers("decimal: point", "-1.5e-03"), "-0.001500 -");
  EXPECT_EQ(numbers("decimal: comma", "1,2E+3"), "1200.000000 1200");
  EXPECT_EQ(numbers("decimal: point", "1e999"), "- -");
}

}  // namespace
}  // namespace evbal
