#include "common/open_file.hpp"

#include "common/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace evbal {

OpenFile::OpenFile(const std::filesystem::path& path, int flags)
    : number_(open(path.c_str(), flags | O_CLOEXEC, 0644)) {
  if (number_ < 0) {
    throw run_failed(path.string() + ": cannot be opened: " + std::strerror(errno));
  }
}

OpenFile::~OpenFile() {
  close(number_);
}

}  // namespace evbal
