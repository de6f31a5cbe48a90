#include "common/folder_lock.hpp"

#include "common/error.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

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

TEST(FolderLock, SaysThatAFolderCannotBeOpened) {
  const Folder folder;
  try {
    ADD_FAILURE() << FolderLock(folder.path() / "none").held();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::run_failed);
    EXPECT_NE(std::string(error.what()).find("none: cannot be opened: No such file or directory"), std::string::npos)
        << error.what();
  }
}

/// From now on the kernel answers flock() in this process as a file system without locks does.
void forbid_locks() {
  std::array<sock_filter, 4> filter = {{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                                        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_flock, 0, 1),
                                        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOLCK),
                                        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)}};
  const sock_fprog program = {filter.size(), filter.data()};
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

TEST(FolderLockDeathTest, TellsAFileSystemWithoutLocksFromAnotherHolder) {
  const Folder folder;
  EXPECT_EXIT(
      {
        forbid_locks();
        try {
          std::_Exit(FolderLock(folder.path()).held() ? 0 : 1);
        } catch (const Error& error) {
          std::fputs(error.what(), stderr);
          std::_Exit(static_cast<int>(error.status()));
        }
      },
      testing::ExitedWithCode(3), "cannot be locked: No locks available; give one on a local file system");
}

}  // namespace
}  // namespace evbal
