#include "common/scratch_folder.hpp"

#include "common/error.hpp"
#include "common/files.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

TEST(ScratchFolder, IsNewAndGoesWithItsOwner) {
  std::filesystem::path path;
  {
    const ScratchFolder one;
    const ScratchFolder other;
    path = one.path();
    EXPECT_TRUE(std::filesystem::is_empty(path));
    EXPECT_NE(path, other.path());
    write_file(path / "file", "text");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ScratchFolder, SaysWhyThereIsNone) {
  try {
    const ScratchFolder folder("/no/such");
    FAIL() << "was made";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "/no/such: no folder can be made here: No such file or directory");
  }
}

}  // namespace
}  // namespace evbal
