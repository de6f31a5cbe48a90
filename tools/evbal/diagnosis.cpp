#include "tools/evbal/diagnosis.hpp"

#include "common/error.hpp"
#include "common/installation.hpp"
#include "coordinator/convex/ipopt_engine.hpp"
#include "experiments/conductor/domain_lock.hpp"
#include "experiments/conductor/machine_needs.hpp"
#include "experiments/run/leftovers.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <thread>
#include <utility>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// The shared libraries of this program, as the files that they really are: their names end in the version.
std::set<std::string> libraries() {
  std::set<std::string> names;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const auto at = line.find('/');
    for (const char* part :
         {"fastrtps", "fastdds", "fastcdr", "libClp", "dmumps_seq", "openblas", "liblapack", "mrpt-math", "sqlite3"}) {
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

/// What may be one way or the other, and may explain much.
void add_facts(std::vector<Finding>& findings) {
  const auto add = [&findings](std::string what) { findings.push_back({std::move(what), std::nullopt, ""}); };
  const int buffer = granted_socket_buffer() / 1024;
  add("socket buffers of " + std::to_string(buffer) + " KiB" +
      (buffer < 4096 ? "; with hundreds of agents, more is faster: `sysctl -w net.core.rmem_max=4194304 "
                       "net.core.wmem_max=4194304`"
                     : ""));
  add(access("/dev/net/tun", R_OK | W_OK) == 0
          ? "/dev/net/tun, for scenarios with `network`"
          : "no /dev/net/tun, which scenarios with `network` need: run as root, or let this user read and write it");
  if (const int files = shared_memory_files(); files > 0) {
    add(std::to_string(files) + " files of Fast DDS in /dev/shm, of other programs: evbal makes none");
  }
  add(std::to_string(std::thread::hardware_concurrency()) + " processors");
  add("Ipopt " + ipopt_version());
  for (const auto& name : libraries()) {
    add(name);
  }
}

/// Whether a run of 60 processes would find a DDS domain.
Finding ports_of_a_domain() {
  std::string complaint;
  try {
    const DomainLock lock(60);
  } catch (const Error& error) {
    complaint = error.what();
  }
  return {"UDP ports of a DDS domain", complaint.empty(), complaint};
}

}  // namespace

std::vector<Finding> diagnose(bool clean) {
  std::vector<Finding> findings;
  const fs::path folder = own_folder();
  for (const auto& need : machine_needs(folder)) {
    findings.push_back({need.what, need.met, need.cure});
  }
  findings.push_back({"evbal-bridge", access((folder / "evbal-bridge").c_str(), X_OK) == 0,
                      "is no program in " + folder.string() + "; build or install it there"});
  findings.push_back(ports_of_a_domain());
  for (const auto& left : find_leftovers()) {
    if (clean) {
      left.remove();
      findings.push_back({"removed " + left.what, std::nullopt, ""});
    } else {
      findings.push_back({left.what, false, "left over; `evbal doctor --clean` removes it"});
    }
  }
  add_facts(findings);
  return findings;
}

}  // namespace evbal
