#pragma once

#include "common/command.hpp"
#include "common/pipe.hpp"
#include "experiments/conductor/kept_host.hpp"

#include <sys/types.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace evbal {

/// How a process of a run ended.
struct Death {
  std::string process;  ///< its name
  std::string how;      ///< "process 4711 was ended by signal 9 (Killed)"
};

/// The hosts of a run beside this one, and what is sent there before a process of that name is started.
struct OtherHosts {
  std::vector<std::unique_ptr<KeptHost>> hosts;                               ///< all there
  std::function<std::vector<SentFile>(const std::string& process)> files_of;  ///< asked at each start
};

/// The processes of a run, here and on other hosts. Each one's standard input is a pipe that this object holds open and
/// whose end is theirs to watch; what they print goes to `NAME.log`. What is on a host that is gone goes on on another
/// one. When destroyed it closes the pipe, gives all of them together `time_for_farewell` (agents/hosting/process.hpp)
/// to end, and kills those that are left.
class Supervisor {
 public:
  /// Logs go to `log_folder`, which is made if it is missing.
  explicit Supervisor(std::filesystem::path log_folder, OtherHosts others = {});
  ~Supervisor();
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// In the network namespace of a file, if one is given. Throws Error{run_failed} if the program cannot be started.
  void start(const std::string& name, const std::filesystem::path& program, const std::vector<std::string>& arguments,
             int network = -1);

  /// Starts evbal-agent on one of the other hosts, by its position. Throws Error{run_failed} if it cannot be started
  /// there, or if no host is left.
  void start_there(const std::string& name, int host, const std::vector<std::string>& arguments);

  /// Starts again the processes that a signal from outside has ended, or whose host is gone, and says which. Throws
  /// Error{run_failed}, with its name, how it ended and its last words, if one ended by itself, crashed, or has ended
  /// too often since the last progress().
  std::vector<Death> revive();

  /// The hosts that were found to be gone since the last call, each with the reason.
  std::vector<std::string> hosts_gone() { return std::exchange(hosts_gone_, {}); }

  /// Kills a process, as somebody from outside does: revive() starts it again.
  void strike(const std::string& name) { send_signal(find(name), SIGKILL); }

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
  static constexpr int here = -1;

  struct Process {
    std::string name;
    Command command;   ///< program and arguments
    int network = -1;  ///< namespace, as a file
    int host = here;   ///< position among the other hosts
    pid_t id = 0;      ///< 0 once reaped
    int deaths = 0;    ///< since the last progress
  };

  void spawn(Process& process);
  void spawn_there(Process& process);
  void send_signal(const Process& process, int number);
  void note_death(Process& process, int status, std::vector<Death>& deaths);
  void revive_there(std::vector<Death>& deaths);
  void leave(int host, const std::string& why, std::vector<Death>& deaths);
  int best_host() const;
  Process& find(const std::string& name);
  void reap_ended();
  bool any_left() const;

  std::filesystem::path log_folder_;
  Pipe pipe_;
  std::vector<Process> processes_;
  OtherHosts others_;
  std::set<int> left_;  ///< hosts that are gone
  std::vector<std::string> hosts_gone_;
};

}  // namespace evbal
