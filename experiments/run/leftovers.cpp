#include "experiments/run/leftovers.hpp"

#include "common/error.hpp"
#include "common/run_program.hpp"
#include "experiments/run/run_folder.hpp"
#include "experiments/scenario/hosts.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto longest_answer = 30s;  // of another host

std::vector<std::string> command_line(const std::string& process) {
  std::ifstream in("/proc/" + process + "/cmdline");
  std::vector<std::string> words;
  for (std::string word; std::getline(in, word, '\0');) {
    words.push_back(word);
  }
  return words;
}

/// 0 if there is no such process.
pid_t parent_of(const std::string& process) {
  std::ifstream in("/proc/" + process + "/stat");
  std::string line;
  std::getline(in, line);
  const auto name_ends = line.rfind(')');  // a program's name may have blanks and brackets
  return name_ends == std::string::npos ? 0
                                        : static_cast<pid_t>(std::strtol(line.c_str() + name_ends + 4, nullptr, 10));
}

/// A process that takes part in a run whose launcher is gone.
struct Orphan {
  std::string program;
  std::string run;  ///< its id, which begins with the launcher's process, whose child it was then

  bool operator==(const Orphan&) const = default;
};

/// The process as such, if it is one.
std::optional<Orphan> orphan(const std::string& process) {
  const std::vector<std::string> words = command_line(process);
  const auto option = std::find(words.begin(), words.end(), "--run");
  const bool takes_part = std::find(words.begin(), words.end(), "--participant") != words.end() &&
                          std::find(words.begin(), words.end(), "--journal") != words.end();
  if (!takes_part || option == words.end() || option + 1 == words.end()) {
    return std::nullopt;
  }
  const long launcher = std::strtol((option + 1)->c_str(), nullptr, 10);
  const pid_t parent = parent_of(process);
  const std::vector<std::string> above = command_line(std::to_string(parent));
  const bool kept = above.size() > 1 && above[1] == "keep";  // its launcher is on another host
  if (launcher <= 0 || parent <= 0 || parent == launcher || kept) {
    return std::nullopt;
  }
  return Orphan{fs::path(words.front()).filename(), *(option + 1)};
}

void add_processes(std::vector<Leftover>& found) {
  std::error_code failed;
  for (fs::directory_iterator entry("/proc", failed), end; !failed && entry != end; entry.increment(failed)) {
    const std::string id = entry->path().filename();
    const bool number = id.find_first_not_of("0123456789") == std::string::npos;
    if (const auto left = number ? orphan(id) : std::nullopt) {
      found.push_back({left->program + " (process " + id + ") of run " + left->run, [id, left] {
                         if (orphan(id) == left) {
                           kill(static_cast<pid_t>(std::strtol(id.c_str(), nullptr, 10)), SIGKILL);
                         }
                       }});
    }
  }
}

/// Removes journals or keys of a run that broke off and still has.
void remove_folder(const fs::path& folder, const fs::path& run) {
  std::error_code failed;
  if (broke_off(run)) {
    fs::remove_all(folder, failed);
  }
  if (failed) {
    throw run_failed(folder.string() + ": cannot be removed: " + failed.message());
  }
}

void add_folders_of(const fs::path& run, std::vector<Leftover>& found) {
  std::error_code failed;
  for (fs::recursive_directory_iterator entry(run, failed), end; !failed && entry != end; entry.increment(failed)) {
    const std::string name = entry->path().filename();
    if ((name == "journals" || name == "keys") && entry->is_directory(failed)) {
      found.push_back({entry->path().string() + ", of a run that broke off",
                       [folder = entry->path(), run] { remove_folder(folder, run); }});
    }
  }
}

/// Folders that cannot be read are passed over: they are none of ours.
void add_folders(std::vector<Leftover>& found) {
  std::error_code failed;
  for (fs::directory_iterator run("runs", failed), end; !failed && run != end; run.increment(failed)) {
    std::error_code unreadable;
    if (run->is_directory(unreadable) && broke_off(run->path())) {
      add_folders_of(run->path(), found);
    }
  }
}

/// The hosts that a run's scenario names, by their names in messages.
void add_hosts_of(const fs::path& run, std::map<std::string, HostSpec>& hosts) {
  std::error_code failed;
  for (fs::recursive_directory_iterator entry(run, failed), end; !failed && entry != end; entry.increment(failed)) {
    if (entry->path().filename() == "scenario.resolved.yaml") {
      try {
        YamlMap scenario(YamlValue::load(entry->path()));
        const auto list = scenario.find("hosts");
        for (const HostSpec& host : list ? read_hosts(*list) : std::vector<HostSpec>{}) {
          hosts.emplace(shown(host), host);
        }
      } catch (const Error&) {  // no scenario of ours
      }
    }
  }
}

/// What a shell on the host says. Throws Error{run_failed} if it cannot be asked.
std::string answer_of(const HostSpec& host, const std::string& script) {
  const ProgramResult result = run_program(on_host(host, script), longest_answer);
  if (result.status != 0) {
    throw run_failed("host " + shown(host) + " cannot be asked: " + result.errors);
  }
  return result.output;
}

/// Folders of runs (experiments/conductor/kept_host.hpp) that no keeper on the host holds.
void add_folders_on(const HostSpec& host, std::vector<Leftover>& found) {
  try {
    std::istringstream folders(answer_of(host,
                                         "for d in \"${TMPDIR:-/tmp}\"/evbal-host-*; do [ -O \"$d\" ] && "
                                         "flock -n \"$d\" echo \"$d\"; done; true"));
    for (std::string folder; std::getline(folders, folder);) {
      const std::string remove = "flock -n " + shell_word(folder) + " rm -rf " + shell_word(folder);
      found.push_back({folder + " on host " + shown(host), [host, remove] { answer_of(host, remove); }});
    }
  } catch (const Error& error) {
    found.push_back({"perhaps something: " + std::string(error.what()), [error] { throw error; }});
  }
}

void add_hosts(std::vector<Leftover>& found) {
  std::map<std::string, HostSpec> hosts;
  std::error_code failed;
  for (fs::directory_iterator run("runs", failed), end; !failed && run != end; run.increment(failed)) {
    add_hosts_of(run->path(), hosts);
  }
  for (const auto& [name, host] : hosts) {
    add_folders_on(host, found);
  }
}

}  // namespace

std::vector<Leftover> find_leftovers() {
  std::vector<Leftover> found;
  add_processes(found);
  add_folders(found);
  add_hosts(found);
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.what < b.what; });
  return found;
}

}  // namespace evbal
