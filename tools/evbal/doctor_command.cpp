#include "tools/evbal/doctor_command.hpp"

#include "common/error.hpp"
#include "common/installation.hpp"
#include "experiments/conductor/domain_lock.hpp"
#include "experiments/conductor/machine_needs.hpp"
#include "experiments/run/leftovers.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <cstdio>
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

/// The shared libraries of this program, as the files that they really are: their names end in the version.
std::set<std::string> libraries() {
  std::set<std::string> names;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const auto at = line.find('/');
    for (const char* part : {"fastrtps", "fastdds", "fastcdr", "ipopt", "libClp", "dmumps_seq", "openblas", "liblapack",
                             "mrpt-math", "sqlite3"}) {
      if (at != std::string::npos && line.find(part, at) != std::string::npos) {
        names.insert(fs::path(line.substr(at)).filename().string());
      }
    }
  }
  return names;
}

/// Files of shared memory of Fast DDS, which other programs make.
int shared_memory_files() {
  std::error_code error;
  int count = 0;
  for (const auto& entry : fs::directory_iterator("/dev/shm", error)) {
    const std::string name = entry.path().filename();
    count += name.starts_with("fastrtps") || name.starts_with("fastdds") ? 1 : 0;
  }
  return count;
}

/// What is not wrong and may explain much.
void tell_facts(Diagnosis& diagnosis) {
  const int buffer = granted_socket_buffer() / 1024;
  diagnosis.fact("socket buffers of " + std::to_string(buffer) + " KiB" +
                 (buffer < 4096 ? "; with hundreds of agents, more is faster: `sysctl -w net.core.rmem_max=4194304 "
                                  "net.core.wmem_max=4194304`"
                                : ""));
  diagnosis.fact(access("/dev/net/tun", R_OK | W_OK) == 0
                     ? "/dev/net/tun, for scenarios with `network`"
                     : "no /dev/net/tun, which scenarios with `network` need: run as root, or let this user read and "
                       "write it");
  if (const int files = shared_memory_files(); files > 0) {
    diagnosis.fact(std::to_string(files) + " files of Fast DDS in /dev/shm, of other programs: evbal makes none");
  }
  diagnosis.fact(std::to_string(std::thread::hardware_concurrency()) + " processors");
  for (const auto& name : libraries()) {
    diagnosis.fact(name);
  }
}

/// Whether a run of 60 processes would find a DDS domain.
void check_ports(Diagnosis& diagnosis) {
  std::string complaint;
  try {
    const DomainLock lock(60);
  } catch (const Error& error) {
    complaint = error.what();
  }
  diagnosis.check(complaint.empty(), "UDP ports of a DDS domain", complaint);
}

void examine(bool clean) {
  Diagnosis diagnosis;
  const fs::path folder = own_folder();
  for (const auto& need : machine_needs(folder)) {
    diagnosis.check(need.met, need.what, need.cure);
  }
  diagnosis.check(access((folder / "evbal-bridge").c_str(), X_OK) == 0, "evbal-bridge",
                  "is no program in " + folder.string() + "; build or install it there");
  check_ports(diagnosis);
  for (const auto& left : find_leftovers()) {
    if (clean) {
      left.remove();
      diagnosis.fact("removed " + left.what);
    } else {
      diagnosis.check(false, left.what, "left over; `evbal doctor --clean` removes it");
    }
  }
  tell_facts(diagnosis);
  if (diagnosis.troubles() > 0) {
    throw run_failed(std::to_string(diagnosis.troubles()) +
                     (diagnosis.troubles() == 1 ? " thing to mend" : " things to mend"));
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
