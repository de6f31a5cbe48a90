#include "common/folder_lock.hpp"

#include "common/error.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>

namespace evbal {

FolderLock::FolderLock(const std::filesystem::path& folder) : folder_(folder, O_RDONLY | O_DIRECTORY) {
  held_ = flock(folder_.number(), LOCK_EX | LOCK_NB) == 0;
  if (!held_ && errno != EWOULDBLOCK) {
    throw run_failed(folder.string() + ": cannot be locked: " + std::strerror(errno) +
                     "; give one on a local file system");
  }
}

}  // namespace evbal
