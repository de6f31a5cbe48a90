#include "common/new_folder.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

namespace fs = std::filesystem;

TEST(NewFolder, AppearsWhenKept) {
  const Folder folder;
  const fs::path place = folder.path() / "a" / "b";
  {
    NewFolder made(place);
    std::ofstream(made.path() / "file") << "text";
    EXPECT_FALSE(fs::exists(place));
    made.keep();
  }
  EXPECT_EQ(text_of(place / "file"), "text");
  EXPECT_FALSE(fs::exists(place.string() + ".partial"));
}

TEST(NewFolder, LeavesNothingWhenNotKept) {
  const Folder folder;
  { const NewFolder made(folder.path() / "a"); }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(NewFolder, TakesAnEmptyFolderAndNoOther) {
  const Folder folder;
  fs::create_directory(folder.path() / "empty");
  NewFolder(folder.path() / "empty").keep();
  folder.write("full/file", "text");
  EXPECT_THROW(NewFolder(folder.path() / "full"), Error);
  EXPECT_THROW(NewFolder(folder.path() / "full" / "file"), Error);
  EXPECT_THROW(NewFolder(folder.path() / "full" / "file" / "within"), Error);
}

}  // namespace
}  // namespace evbal
