#include "tools/records/text_lines.hpp"

#include "tests/folder.hpp"
#include "tests/packed.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

/// Longer than the reader's buffer, and not so even that it would vanish in compression.
std::string long_text() {
  std::string text;
  for (int i = 0; i < 30'000; ++i) {
    text += std::to_string(i * 7919 % 10'007) + "," + std::to_string(i) + "\n";
  }
  return text;
}

TEST(LineReader, ReadsPlainAndCompressedAlike) {
  const Folder folder;
  const std::string text = long_text();
  EXPECT_EQ(unpacked_text(folder.write("a.csv", text)), text);
  EXPECT_EQ(unpacked_text(folder.write("a.csv.gz", packed(text, "gzip"))), text);
  EXPECT_EQ(unpacked_text(folder.write("a.csv.xz", packed(text, "xz"))), text);
  EXPECT_EQ(unpacked_text(folder.write("empty.csv", "")), "");
  EXPECT_EQ(unpacked_text(folder.write("empty.csv.gz", packed("", "gzip"))), "");
}

TEST(LineReader, TakesLinesOfWindowsAndAnOpenLastLine) {
  const Folder folder;
  LineReader lines(folder.write("a.csv", "a,b\r\n\nlast"));
  std::string line;
  ASSERT_TRUE(lines.next(line));
  EXPECT_EQ(line, "a,b");
  ASSERT_TRUE(lines.next(line));
  EXPECT_EQ(line, "");
  ASSERT_TRUE(lines.next(line));
  EXPECT_EQ(line, "last");
  EXPECT_FALSE(lines.next(line));
}

TEST(LineReader, RefusesATruncatedFile) {
  const Folder folder;
  for (const std::string how : {"gzip", "xz"}) {
    const std::string whole = packed(long_text(), how);
    for (const std::size_t size : {whole.size() / 20, whole.size() / 2, whole.size() - 1}) {
      const auto file = folder.write("a.csv." + how, whole.substr(0, size));
      try {
        unpacked_text(file);
        FAIL() << how << " was accepted, cut after " << size;
      } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::bad_input);
        EXPECT_TRUE(std::string(error.what()).starts_with(file.string() + ":")) << error.what();
      }
    }
  }
  EXPECT_THROW(unpacked_text(folder.path() / "missing"), Error);
}

TEST(LineReader, RefusesWhatHasNoLines) {
  const Folder folder;
  LineReader lines(folder.write("a.csv", "short\n" + std::string(100'000, 'x') + "\n"), 50'000);
  std::string line;
  ASSERT_TRUE(lines.next(line));
  EXPECT_THROW(lines.next(line), Error);
}

/// What is said of a file that is refused.
std::string refusal_of(const std::string& text, std::size_t longest = 1000) {
  const Folder folder;
  try {
    unpacked_text(folder.write("a.csv", text), longest);
  } catch (const Error& error) {
    return error.what();
  }
  return "was accepted";
}

TEST(LineReader, RefusesWhatIsNoTextWithWhatToDo) {
  EXPECT_NE(refusal_of(std::string("\xFF\xFE{\0", 4)).find("a.csv: is UTF-16; save it as UTF-8"), std::string::npos);
  EXPECT_NE(refusal_of("PK\x03\x04zones.geojson").find("a.csv: is a zip archive"), std::string::npos);
}

TEST(LineReader, TakesNoMoreThanItsBound) {
  EXPECT_NE(refusal_of("1234\n5678\n", 9).find("a.csv:2: the text up to here is longer than 9 bytes"),
            std::string::npos);
  EXPECT_EQ(refusal_of("1234\n5678\n", 10), "was accepted");
}

TEST(LineReader, LeavesOutAByteOrderMark) {
  const Folder folder;
  EXPECT_EQ(unpacked_text(folder.write("a.csv.gz", packed("\xEF\xBB\xBF{}", "gzip"))), "{}\n");
}

TEST(TextFiles, AreThoseOfAnyCaseAndCompression) {
  const Folder folder;
  for (const std::string name :
       {"b.CSV", "a.csv", "c.csv.gz", "d.txt.XZ", "e.csv.bz2", "f.Csv.zst", "g.parquet", "h.gz"}) {
    folder.write(name, "");
  }
  std::string names;
  for (const auto& file : text_files(folder.path())) {
    names += file.filename().string() + " ";
  }
  EXPECT_EQ(names, "a.csv b.CSV c.csv.gz d.txt.XZ e.csv.bz2 f.Csv.zst ");
  EXPECT_EQ(csv_files(folder.path()).size(), 5U);
  EXPECT_EQ(without_packing("cab_7.txt.GZ"), "cab_7.txt");
  EXPECT_EQ(without_packing("cab_7.txt"), "cab_7.txt");
}

}  // namespace
}  // namespace evbal
