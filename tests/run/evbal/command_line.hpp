#pragma once

#include "tests/folder.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace evbal {

/// How a call of the program ended.
struct Ended {
  int status = 0;
  std::string out;
  std::string err;
};

/// The status with which a process of ours ends.
inline int wait_for(pid_t id) {
  int status = 0;
  waitpid(id, &status, 0);
  return WEXITSTATUS(status);
}

/// The command line in a folder of its own, with a morning of the toy city to run.
class CommandLine {
 public:
  CommandLine() { scenario("morning.yaml", ""); }

  const std::filesystem::path& path() const { return folder_.path(); }

  /// Writes a scenario of three hours with an outage, to which `more` is added.
  void scenario(const std::string& name, const std::string& more) const {
    folder_.write(name,
                  "schema: 1\n"
                  "city: toy-5\n"
                  "day: 2024-01-11\n"
                  "seed: 1\n"
                  "clock: {start: \"07:00\", end: \"10:00\", tick: 5min, step: 30min, plan_every: 10min}\n"
                  "controllers: [nominal]\n"
                  "transport: inproc\n"
                  "faults:\n"
                  "  schema: 1\n"
                  "  seed: 1\n"
                  "  faults:\n"
                  "    - {name: outage, type: charger.outage, target: {regions: [0]}, start: \"08:00\",\n"
                  "       duration: 45min, magnitude: {fraction_of_points: 1.0}, on_start: evict}\n" +
                      more);
  }

  /// `environment`: variables for the call, as a shell has them before a command.
  Ended evbal(const std::string& arguments, const std::string& environment = "") const {
    return command(environment + " " + EVBAL_PROGRAM + " " + arguments);
  }

  /// What a shell is to do in the folder.
  Ended command(const std::string& words) const {
    const int code = std::system(("cd " + path().string() + " && " + words + " >out.txt 2>err.txt").c_str());
    return {WEXITSTATUS(code), text_of(path() / "out.txt"), text_of(path() / "err.txt")};
  }

  /// Starts the program on its own, once a shell has done `before`.
  pid_t start(const std::string& arguments, const std::string& before = "") const {
    std::string command =
        before + "cd " + path().string() + " && exec " + EVBAL_PROGRAM + " " + arguments + " >out.txt 2>err.txt";
    std::string shell = "/bin/sh";
    std::string option = "-c";
    char* words[] = {shell.data(), option.data(), command.data(), nullptr};
    pid_t id = 0;
    posix_spawn(&id, shell.c_str(), nullptr, nullptr, words, environ);
    return id;
  }

  /// The value of a key of a run's summary.json, as it is written.
  std::string summary(const std::string& run, const std::string& key) const {
    const std::string text = text_of(path() / run / "summary.json");
    const std::string start = "\"" + key + "\": ";
    const auto from = text.find(start);
    if (from == std::string::npos) {
      return "";
    }
    return text.substr(from + start.size(), text.find_first_of(",\n", from) - from - start.size());
  }

 private:
  Folder folder_;
};

}  // namespace evbal
