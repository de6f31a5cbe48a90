#include "tools/records/lines.hpp"

#include "tests/folder.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

namespace evbal {
namespace {

/// `text` as a gzip file.
std::string gzipped(const std::string& text) {
  std::string bytes(text.size() + 10'000, '\0');
  std::size_t used = 0;
  archive* writer = archive_write_new();
  archive_write_set_format_raw(writer);
  archive_write_add_filter_gzip(writer);
  archive_write_open_memory(writer, bytes.data(), bytes.size(), &used);
  archive_entry* entry = archive_entry_new();
  archive_entry_set_filetype(entry, AE_IFREG);
  archive_write_header(writer, entry);
  archive_write_data(writer, text.data(), text.size());
  archive_entry_free(entry);
  archive_write_close(writer);
  archive_write_free(writer);
  return bytes.substr(0, used);
}

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
  EXPECT_EQ(unpacked_text(folder.write("a.csv.gz", gzipped(text))), text);
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
  const std::string whole = gzipped(long_text());
  const auto file = folder.write("a.csv.gz", whole.substr(0, whole.size() / 2));
  try {
    unpacked_text(file);
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    EXPECT_TRUE(std::string(error.what()).starts_with(file.string() + ":")) << error.what();
    EXPECT_NE(std::string(error.what()).find("truncated"), std::string::npos) << error.what();
  }
  EXPECT_THROW(unpacked_text(folder.path() / "missing"), Error);
}

TEST(SplitCsv, KeepsCommasInQuotes) {
  EXPECT_EQ(split_csv("a,\"b, c\",,\"say \"\"d\"\"\""), (std::vector<std::string>{"a", "b, c", "", "say \"d\""}));
  EXPECT_EQ(split_csv(""), std::vector<std::string>{""});
}

}  // namespace
}  // namespace evbal
