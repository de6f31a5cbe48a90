#include "agents/hosting/keeper.hpp"

#include "agents/bus/ports.hpp"
#include "agents/hosting/host_words.hpp"
#include "agents/hosting/process.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/pipe.hpp"
#include "common/spawn.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <list>
#include <utility>

namespace evbal {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds between_looks = 20ms;  // at who has ended
constexpr auto between_words = 1s;                         // that the launcher hears at least

class Keeper {
 public:
  Keeper(std::string address, std::chrono::seconds lease)
      : address_(std::move(address)), lease_(lease), said_(Clock::now()) {
    std::signal(SIGPIPE, SIG_IGN);
    fcntl(STDIN_FILENO, F_SETFL, O_NONBLOCK);
    fcntl(STDOUT_FILENO, F_SETFL, O_NONBLOCK);
    to_say_ = keeper_greeting;
  }

  ~Keeper() {
    for (Process& process : processes_) {
      end_now(process);
    }
    std::error_code kept;
    fs::remove_all(folder_, kept);
  }
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;

  /// Until the launcher has it end, or is gone.
  void keep() {
    auto heard = Clock::now();
    do {
      std::vector<pollfd> files = {{STDIN_FILENO, POLLIN, 0}};
      if (!to_say_.empty()) {
        files.push_back({STDOUT_FILENO, POLLOUT, 0});
      }
      poll(files.data(), files.size(), static_cast<int>(between_looks.count()));
      if (files.front().revents != 0 && hear()) {
        heard = Clock::now();
      }
      look_after_processes();
      if (Clock::now() - said_ > between_words) {
        say({});
      }
      over_ = !write_some(STDOUT_FILENO, to_say_) || over_;
    } while (!over_ && Clock::now() - heard < lease_);
  }

 private:
  struct Process {
    explicit Process(std::string own_name) : name(std::move(own_name)) {}

    std::string name;
    Pipe input{};   ///< whose end is the process's to watch
    Pipe output{};  ///< what it prints
    pid_t id = 0;   ///< 0 once it has ended
  };

  void say(const HostNews& news) {
    to_say_ += frame(news);
    said_ = Clock::now();
  }

  /// Takes what has come from the launcher and does it; false if nothing has.
  bool hear() {
    std::array<char, 1 << 16> part{};
    const ssize_t length = read(STDIN_FILENO, part.data(), part.size());
    over_ = over_ || length == 0;
    if (length <= 0) {
      return false;
    }
    orders_.add({part.data(), static_cast<std::size_t>(length)});
    while (const auto order = orders_.next<HostOrder>()) {
      obey(*order);
    }
    return true;
  }

  void obey(const HostOrder& order) {
    switch (order.kind) {
      case HostOrderKind::alive:
        break;
      case HostOrderKind::start:
        start(order);
        break;
      case HostOrderKind::signal:
        send_signal(order.process, order.number);
        break;
      case HostOrderKind::ports:
        say({.kind = HostNewsKind::ports, .text = complaint_of_ports(order.number, order.last_port)});
        break;
      case HostOrderKind::end:
        end_all();
        break;
    }
  }

  void start(const HostOrder& order) {
    try {
      for (const auto& file : order.files) {
        fs::create_directories((folder_ / file.name).parent_path());
        write_file(folder_ / file.name, file.bytes);
      }
      processes_.remove_if([&](const Process& process) { return process.name == order.process; });
      Process& process = processes_.emplace_back(order.process);
      Command command = {(folder_ / program_).string()};
      command.insert(command.end(), order.words.begin(), order.words.end());
      command.insert(command.end(), {"--host", address_});
      const int output = process.output.write_end();
      process.id = spawn(command, {.input = process.input.read_end(), .output = output, .errors = output});
      process.output.close_write_end();
      fcntl(process.output.read_end(), F_SETFL, O_NONBLOCK);
      say({.kind = HostNewsKind::started, .process = order.process, .number = process.id});
    } catch (const Error& error) {
      say({.kind = HostNewsKind::not_started, .process = order.process, .text = error.what()});
    }
  }

  void send_signal(const std::string& name, int number) {
    for (Process& process : processes_) {
      if (process.name == name && process.id != 0) {
        kill(process.id, number);
        reap(process, number == SIGKILL ? 0 : WNOHANG);
      }
    }
  }

  std::string complaint_of_ports(int first, int last) const {
    for (int port = first; port <= last; ++port) {
      if (const std::string why = port_complaint(address_, port); !why.empty()) {
        return "UDP port " + std::to_string(port) + " of " + address_ + ": " + why;
      }
    }
    return "";
  }

  void look_after_processes() {
    for (Process& process : processes_) {
      if (process.id != 0) {
        pass_on(process);
        reap(process, WNOHANG);
      }
    }
  }

  /// Tells what the process has printed.
  void pass_on(const Process& process) {
    std::array<char, 1 << 12> part{};
    ssize_t length = 0;
    while ((length = read(process.output.read_end(), part.data(), part.size())) > 0) {
      say({.kind = HostNewsKind::printed,
           .process = process.name,
           .text = {part.data(), static_cast<std::size_t>(length)}});
    }
  }

  /// Tells of the process's end, if it has come.
  void reap(Process& process, int options) {
    int status = 0;
    if (waitpid(process.id, &status, options) == process.id) {
      pass_on(process);
      say({.kind = HostNewsKind::ended,
           .process = process.name,
           .number = std::exchange(process.id, 0),
           .text = std::to_string(status)});
    }
  }

  static void end_now(Process& process) {
    if (process.id != 0) {
      kill(process.id, SIGKILL);
      waitpid(std::exchange(process.id, 0), nullptr, 0);
    }
  }

  bool any_left() const {
    for (const Process& process : processes_) {
      if (process.id != 0) {
        return true;
      }
    }
    return false;
  }

  /// Gives all time to end, then tells what their legs took.
  void end_all() {
    for (Process& process : processes_) {
      process.input.close_write_end();
      if (process.id != 0) {
        kill(process.id, SIGCONT);  // who stands still cannot see the pipe close
      }
    }
    const auto deadline = Clock::now() + time_for_farewell;
    for (look_after_processes(); any_left() && Clock::now() < deadline; look_after_processes()) {
      poll(nullptr, 0, 5);
    }
    for (Process& process : processes_) {
      end_now(process);
      say({.kind = HostNewsKind::legs,
           .process = process.name,
           .text = text_of_file(legs_file(folder_ / process.name))});
    }
    say_rest();
    over_ = true;
  }

  /// All that is still to be said, as long as the launcher takes it.
  void say_rest() {
    const auto deadline = Clock::now() + lease_;
    while (!to_say_.empty() && Clock::now() < deadline && write_some(STDOUT_FILENO, to_say_)) {
      pollfd file{STDOUT_FILENO, POLLOUT, 0};
      poll(&file, 1, static_cast<int>(between_looks.count()));
    }
  }

  std::string address_;
  std::chrono::seconds lease_;
  fs::path folder_ = fs::current_path();
  fs::path program_ = fs::read_symlink("/proc/self/exe").filename();
  FrameReader orders_;
  std::string to_say_;
  Clock::time_point said_;
  bool over_ = false;
  std::list<Process> processes_;
};

}  // namespace

int run_keeper(int argc, char** argv) {
  constexpr int words = 4;
  try {
    if (argc != words) {
      throw bad_input(std::string(argv[0]) + " " + keeper_word + ": expected an address and a lease in seconds");
    }
    Keeper(argv[2], std::chrono::seconds(std::stoi(argv[3]))).keep();
    return static_cast<int>(ExitStatus::ok);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(ExitStatus::run_failed);
  }
}

}  // namespace evbal
