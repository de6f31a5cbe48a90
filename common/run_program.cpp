#include "common/run_program.hpp"

#include "common/error.hpp"
#include "common/open_file.hpp"
#include "common/pipe.hpp"
#include "common/spawn.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

namespace evbal {
namespace {

constexpr int glance_ms = 10;  // between looks whether the program has ended, while it says nothing

/// Text that comes through a pipe, read as it comes.
class Heard {
 public:
  explicit Heard(const Pipe& pipe) : file_(pipe.read_end()) { fcntl(file_, F_SETFL, O_NONBLOCK); }

  /// Takes what is there now.
  void take() {
    std::array<char, 4096> part{};
    ssize_t length = 0;
    while (file_ >= 0 && (length = read(file_, part.data(), part.size())) > 0) {
      text_.append(part.data(), static_cast<std::size_t>(length));
    }
    if (length == 0) {
      file_ = -1;  // its end: poll() passes over it
    }
  }

  int file() const { return file_; }
  const std::string& text() const { return text_; }

 private:
  int file_;
  std::string text_;
};

/// A program at work, with no input. Killed, with what it started, if it is left before it has ended.
class Program {
 public:
  Program(const Command& command, const Pipe& output, const Pipe& errors) {
    const OpenFile nothing("/dev/null", O_RDONLY);
    id_ = spawn(command, {.input = nothing.number(), .output = output.write_end(), .errors = errors.write_end()});
  }
  ~Program() {
    if (!ended_) {
      kill(-id_, SIGKILL);
      waitpid(id_, nullptr, 0);
    }
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  bool ended() {
    ended_ = ended_ || waitpid(id_, &status_, WNOHANG) == id_;
    return ended_;
  }
  int status() const { return status_; }

 private:
  pid_t id_ = 0;
  int status_ = 0;
  bool ended_ = false;
};

}  // namespace

ProgramResult run_program(const Command& command, std::chrono::milliseconds at_most) {
  Pipe output_pipe;
  Pipe errors_pipe;
  Program program(command, output_pipe, errors_pipe);
  output_pipe.close_write_end();
  errors_pipe.close_write_end();
  Heard output(output_pipe);
  Heard errors(errors_pipe);
  const auto deadline = std::chrono::steady_clock::now() + at_most;
  for (bool ended = false; !ended;) {
    ended = program.ended();
    output.take();
    errors.take();
    if (!ended && std::chrono::steady_clock::now() > deadline) {
      throw run_failed("`" + shown(command) + "` did not end within " + std::to_string(at_most.count()) + " ms");
    }
    std::array<pollfd, 2> files = {{{output.file(), POLLIN, 0}, {errors.file(), POLLIN, 0}}};
    if (!ended) {
      poll(files.data(), files.size(), glance_ms);
    }
  }
  return {program.status(), output.text(), errors.text()};
}

}  // namespace evbal
