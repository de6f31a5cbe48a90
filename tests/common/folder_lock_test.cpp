#include "common/folder_lock.hpp"

#include "tests/folder.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(FolderLock, IsHeldByOneAtATime) {
  const Folder folder;
  {
    const FolderLock first(folder.path());
    EXPECT_TRUE(first.held());
    EXPECT_FALSE(FolderLock(folder.path()).held());
  }
  EXPECT_TRUE(FolderLock(folder.path()).held());
}

TEST(FolderLock, HoldsNothingThatIsNotThere) {
  const Folder folder;
  EXPECT_FALSE(FolderLock(folder.path() / "none").held());
}

}  // namespace
}  // namespace evbal
