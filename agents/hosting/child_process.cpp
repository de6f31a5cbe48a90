#include "agents/hosting/child_process.hpp"

#include "common/command.hpp"
#include "common/error.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace evbal {
namespace {

constexpr int no_program = 127;  // as shells have it

struct Pipe {
  Pipe() {
    if (pipe(ends.data()) != 0) {
      throw run_failed(std::string("no pipe to a child process: ") + std::strerror(errno));
    }
  }
  std::array<int, 2> ends{};  // to read from, to write to
};

std::string ending(int status) {
  if (WIFSIGNALED(status)) {
    return "was ended by signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
  }
  return WEXITSTATUS(status) == no_program ? "could not be started"
                                           : "ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

ChildProcess::ChildProcess(std::vector<std::string> command) : command_(std::move(command)) {
  std::vector<char*> words;
  words.reserve(command_.size() + 1);
  for (auto& word : command_) {
    words.push_back(word.data());
  }
  words.push_back(nullptr);
  const Pipe there;
  const Pipe back;
  id_ = fork();
  if (id_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(there.ends[0], STDIN_FILENO);
    dup2(back.ends[1], STDOUT_FILENO);
    closefrom(STDERR_FILENO + 1);
    execvp(words.front(), words.data());
    _exit(no_program);
  }
  close(there.ends[0]);
  close(back.ends[1]);
  to_ = fdopen(there.ends[1], "w");
  from_ = fdopen(back.ends[0], "r");
  if (id_ < 0 || to_ == nullptr || from_ == nullptr) {
    throw run_failed("no process for `" + shown(command_) + "`: " + std::strerror(errno));
  }
  std::signal(SIGPIPE, SIG_IGN);
}

ChildProcess::~ChildProcess() {
  std::fclose(to_);
  std::fclose(from_);
  if (id_ != 0) {
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }
}

void ChildProcess::write(const std::string& line) {
  std::fprintf(to_, "%s\n", line.c_str());
  std::fflush(to_);
}

std::string ChildProcess::read(const std::string& what) {
  char* text = nullptr;
  std::size_t room = 0;
  const auto size = getline(&text, &room, from_);
  std::string line(text, size > 0 ? static_cast<std::size_t>(size) : 0);
  std::free(text);
  if (size <= 0) {
    int status = 0;
    kill(id_, SIGKILL);  // a child that has only closed its output
    waitpid(std::exchange(id_, 0), &status, 0);
    throw run_failed("`" + shown(command_) + "` " + ending(status) + " and owes " + what);
  }
  ++lines_read_;
  if (line.ends_with('\n')) {
    line.pop_back();
  }
  return line;
}

}  // namespace evbal
