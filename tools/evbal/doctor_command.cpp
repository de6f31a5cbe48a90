#include "tools/evbal/doctor_command.hpp"

#include "common/error.hpp"
#include "common/installation.hpp"
#include "experiments/run/leftovers.hpp"

#include <CLI/CLI.hpp>
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <thread>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// Lines of a diagnosis, and how many of them name trouble.
class Diagnosis {
 public:
  void fact(const std::string& what) { std::printf("      %s\n", what.c_str()); }

  void check(bool well, const std::string& what, const std::string& remedy) {
    std::printf("%s  %s%s\n", well ? "  ok" : "LACK", what.c_str(), well ? "" : (": " + remedy).c_str());
    troubles_ += well ? 0 : 1;
  }

  int troubles() const { return troubles_; }

 private:
  int troubles_ = 0;
};

/// Does a datagram come back over 127.0.0.1?
bool loopback_works() {
  const int receiver = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const int sender = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  const timeval patience{.tv_sec = 1, .tv_usec = 0};
  setsockopt(receiver, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  char byte = 'x';
  const bool works = bind(receiver, generic, size) == 0 && getsockname(receiver, generic, &size) == 0 &&
                     sendto(sender, &byte, 1, 0, generic, size) == 1 && recv(receiver, &byte, 1, 0) == 1;
  close(receiver);
  close(sender);
  return works;
}

/// The shared libraries of this program, as the files that they really are: their names end in the version.
std::set<std::string> libraries() {
  std::set<std::string> names;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const auto at = line.find('/');
    for (const char* part :
         {"fastrtps", "fastcdr", "ipopt", "libClp", "dmumps_seq", "openblas", "liblapack", "mrpt-math", "sqlite3"}) {
      if (at != std::string::npos && line.find(part, at) != std::string::npos) {
        names.insert(fs::path(line.substr(at)).filename().string());
      }
    }
  }
  return names;
}

/// Shared memory that the bus never uses here; other programs of Fast DDS may.
int shared_memory_files() {
  std::error_code error;
  int count = 0;
  for (const auto& entry : fs::directory_iterator("/dev/shm", error)) {
    count += entry.path().filename().string().find("fastrtps") != std::string::npos ? 1 : 0;
  }
  return count;
}

void examine(bool clean) {
  Diagnosis diagnosis;
  const fs::path folder = own_folder();
  for (const char* program : {"evbal-agent", "evbal-coordinator", "evbal-faults", "evbal-bridge"}) {
    diagnosis.check(access((folder / program).c_str(), X_OK) == 0, program,
                    "not beside evbal in " + folder.string() + "; build it");
  }
  diagnosis.check(loopback_works(), "UDP over 127.0.0.1", "no datagram came back; bring the loopback interface up");
  for (const auto& left : find_leftovers()) {
    if (clean) {
      left.remove();
      diagnosis.fact("removed " + left.what);
    } else {
      diagnosis.check(false, left.what, "left over; `evbal doctor --clean` removes it");
    }
  }
  const int files = shared_memory_files();
  diagnosis.check(files == 0, "no shared memory of Fast DDS",
                  std::to_string(files) + " files in /dev/shm; evbal makes none, remove them if no other program does");
  diagnosis.fact(std::to_string(std::thread::hardware_concurrency()) + " processors");
  for (const auto& name : libraries()) {
    diagnosis.fact(name);
  }
  if (diagnosis.troubles() > 0) {
    throw run_failed(std::to_string(diagnosis.troubles()) + " things to mend");
  }
}

}  // namespace

void add_doctor_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("doctor", "Say what this machine lacks and what runs left over that broke off");
  const auto clean = std::make_shared<bool>(false);
  command->add_flag("--clean", *clean, "Remove what they left over");
  command->callback([clean] { examine(*clean); });
}

}  // namespace evbal
