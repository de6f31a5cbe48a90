#include "common/pipe.hpp"

#include "common/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

namespace evbal {
namespace {

void close_once(int& file) {
  if (file >= 0) {
    close(std::exchange(file, -1));
  }
}

}  // namespace

Pipe::Pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw run_failed(std::string("no pipe can be made: ") + std::strerror(errno));
  }
  read_end_ = ends[0];
  write_end_ = ends[1];
}

Pipe::~Pipe() {
  close_read_end();
  close_write_end();
}

void Pipe::close_read_end() {
  close_once(read_end_);
}

void Pipe::close_write_end() {
  close_once(write_end_);
}

}  // namespace evbal
