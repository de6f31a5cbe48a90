#include "common/files.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tests/support/full_disk.hpp"

#include <gtest/gtest.h>

#include <iterator>

namespace evbal {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t files_in(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), {});
}

void expect_refused(const fs::path& file, const std::string& reason) {
  try {
    write_file(file, std::string(1000, 'x'));
    FAIL() << "was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::run_failed);
    EXPECT_EQ(error.what(), file.string() + ": cannot be written: " + reason);
  }
}

TEST(Files, AreWrittenWhole) {
  const Folder folder;
  const fs::path file = folder.write("a", "before");
  write_file(file, "after\n");
  EXPECT_EQ(text_of_file(file), "after\n");
  EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(Files, StayAsTheyWereIfTheDiskIsFull) {
  const Folder folder;
  const fs::path file = folder.write("a", "as it was");
  {
    const FullDisk full(100);
    expect_refused(file, "File too large");
    expect_refused(folder.path() / "b", "File too large");
  }
  EXPECT_EQ(text_of_file(file), "as it was");
  EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(Files, SayWhyTheyCannotBeWritten) {
  const Folder folder;
  expect_refused(folder.path() / "no" / "such", "No such file or directory");
  expect_refused(folder.path(), "Is a directory");
  expect_refused("/dev/full", "No space left on device");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(Files, AreWrittenWhereALinkLeads) {
  const Folder folder;
  const fs::path file = folder.write("a", "before");
  fs::create_symlink("a", folder.path() / "link");
  write_file(folder.path() / "link", "after");
  EXPECT_EQ(text_of_file(file), "after");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
}

TEST(Files, LeaveNothingIfTheyAreNotKept) {
  const Folder folder;
  { NewFile(folder.path() / "a").write("half of it"); }
  EXPECT_EQ(files_in(folder.path()), 0);
}

}  // namespace
}  // namespace evbal
