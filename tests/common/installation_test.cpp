#include "common/installation.hpp"

#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// $PATH as long as the object lives.
class SearchPath {
 public:
  explicit SearchPath(const std::string& path) : before_(std::getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
  ~SearchPath() { setenv("PATH", before_.c_str(), 1); }
  SearchPath(const SearchPath&) = delete;
  SearchPath& operator=(const SearchPath&) = delete;

 private:
  std::string before_;
};

TEST(Installation, FindsAProgramBehindFoldersThatCannotBeRead) {
  const Folder folder;
  const fs::path program = folder.write("bin/mine", "#!/bin/sh\n");
  fs::permissions(program, fs::perms::owner_all);
  fs::create_symlink("loop", folder.path() / "loop");  // cannot be resolved, not even by root
  const SearchPath path((folder.path() / "loop").string() + ":/root/no-such:" + (folder.path() / "bin").string());
  EXPECT_EQ(find_program("mine"), program);
  EXPECT_EQ(find_program("not-mine"), fs::path());
  EXPECT_EQ(find_program((folder.path() / "loop" / "mine").string()), fs::path());
}

}  // namespace
}  // namespace evbal
