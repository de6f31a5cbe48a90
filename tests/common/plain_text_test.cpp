#include "common/plain_text.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(PlainText, FindsWhatIsNoUtf8) {
  const std::string sound = "a\u00fc\u6df1\U0001f696";
  EXPECT_EQ(find_invalid_utf8(sound), std::string::npos);
  for (const std::string bytes : {"\xff", "\x80", "\xc3", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80",
                                  "\xf0\x80\x80\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xe6\xb7"}) {
    EXPECT_EQ(find_invalid_utf8(sound + bytes + "a"), sound.size());
  }
}

TEST(PlainText, SaysWhatIsNoLine) {
  EXPECT_EQ(validate_line("a \u00fc, \"b\"!"), "");
  EXPECT_NE(validate_line("a\nb").find("line break"), std::string::npos);
  EXPECT_NE(validate_line("a\tb").find("control"), std::string::npos);
  EXPECT_NE(validate_line(std::string("a\0b", 3)).find("control"), std::string::npos);
  EXPECT_NE(validate_line("\xff").find("UTF-8"), std::string::npos);
}

TEST(PlainText, SaysWhatCannotNameAFile) {
  for (const std::string name : {"a", "a b", "\u6df1\u5733", "a..b", "-"}) {
    EXPECT_EQ(validate_file_name(name), "") << name;
  }
  for (const std::string name : {"", ".", "..", "../x", "a/b", "/", ".hidden", "a\nb", "\xff"}) {
    EXPECT_NE(validate_file_name(name), "") << name;
  }
  EXPECT_NE(validate_file_name(std::string(101, 'x')), "");
}

}  // namespace
}  // namespace evbal
