#pragma once

#include "common/command.hpp"
#include "common/pipe.hpp"

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// How a process of a run ended.
struct Death {
  std::string process;  ///< its name
  std::string how;      ///< "process 4711 was ended by signal 9 (Killed)"
};

/// The processes of a run. Each one's standard input is a pipe that this object holds open and whose end is theirs to
/// watch; what they print goes to `NAME.log`. When destroyed it closes the pipe, gives all of them together
/// `time_for_farewell` (agents/hosting/process.hpp) to end, and kills those that are left.
class Supervisor {
 public:
  /// Logs go to `log_folder`, which is made if it is missing.
  explicit Supervisor(std::filesystem::path log_folder);
  ~Supervisor();
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// In the network namespace of a file, if one is given. Throws Error{run_failed} if the program cannot be started.
  void start(const std::string& name, const std::filesystem::path& program, const std::vector<std::string>& arguments,
             int network = -1);

  /// Starts again the processes that a signal from outside has ended, and says which. Throws Error{run_failed}, with
  /// its name, how it ended and its last words, if one ended by itself, crashed, or has ended too often since the last
  /// progress().
  std::vector<Death> revive();

  /// Kills a process, which stays away until start_again(), or makes it stand still until go_on().
  void kill(const std::string& name);
  /// Starts a process that has ended, with the same command. Throws Error{run_failed}.
  void start_again(const std::string& name);
  /// Pauses a process (SIGSTOP).
  void stop(const std::string& name);
  /// Lets a paused process go on (SIGCONT).
  void go_on(const std::string& name);

  /// Forgets how often each process has ended: the run has come further.
  void progress();

  /// Of the process started under that name, which exists.
  pid_t process_id(const std::string& name) const;

  /// ": " and the last three lines that a process has printed, blank ones left out; empty if there are none.
  std::string last_words(const std::string& name) const;

 private:
  struct Process {
    std::string name;
    Command command;   ///< program and arguments
    int network = -1;  ///< namespace, as a file
    pid_t id = 0;      ///< 0 once reaped
    int deaths = 0;    ///< since the last progress
  };

  void spawn(Process& process);
  Process& find(const std::string& name);
  void reap_ended();
  bool any_left() const;

  std::filesystem::path log_folder_;
  Pipe pipe_;
  std::vector<Process> processes_;
};

}  // namespace evbal
