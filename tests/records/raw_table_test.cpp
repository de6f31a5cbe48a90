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

}  // namespace
}  // namespace evbal
