#pragma once

#include "agents/hosting/host_words.hpp"
#include "common/pipe.hpp"
#include "experiments/scenario/hosts.hpp"

#include <sys/types.h>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace evbal {

/// Where the launcher finds what goes to another host, and leaves what comes from there.
struct HostFolders {
  std::filesystem::path programs;  ///< where evbal-agent is, which is sent
  std::filesystem::path logs;      ///< NAME.log takes what a process prints
  std::filesystem::path legs;      ///< NAME.legs takes what its legs took
};

/// How long a keeper and its launcher are believed to be there, since the last word from them.
constexpr std::chrono::seconds host_lease{15};

/// Another host of a run, through its keeper (agents/hosting/keeper.hpp), which this object starts there and ends. The
/// program is sent, so nothing of evbal's need be there. The host is gone once the keeper's connection has ended or the
/// lease is over without a word from it; it does not come back then, and the keeper, should it live, ends itself.
class KeptHost {
 public:
  /// Starts the keeper and does not wait for it. This process ignores SIGPIPE from then on. Throws Error{run_failed} if
  /// the program that is to start it over there cannot be started.
  KeptHost(const HostSpec& host, int number, HostFolders folders);

  /// As end() does, then lets go of the connection.
  ~KeptHost();
  KeptHost(const KeptHost&) = delete;
  KeptHost& operator=(const KeptHost&) = delete;

  /// What the scenario says of it.
  const HostSpec& spec() const { return host_; }

  /// Throws Error{run_failed}, with the last words from there, if the keeper is not there after so long.
  void await(std::chrono::milliseconds patience);

  /// Why the host is gone; empty as long as it is there.
  std::string gone();

  /// Starts evbal-agent there with these arguments, once the files are, and gives its process id; nothing if the host
  /// is gone. Throws Error{run_failed} if it cannot be started there.
  std::optional<pid_t> start(const std::string& process, const std::vector<std::string>& arguments,
                             const std::vector<SentFile>& files);

  /// Sends a process there a signal. Orders are obeyed in turn.
  void send_signal(const std::string& process, int number);

  /// Of the processes there that have ended since the last call.
  std::vector<HostNews> ended();

  /// Why one of the UDP ports first..last cannot be had there; empty if all can, or if the host is gone.
  std::string complaint_of_ports(int first, int last);

  /// Asks the keeper to end its processes and itself.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  void talk();
  bool hear();
  void take(HostNews news);
  void order(const HostOrder& order);
  std::optional<HostNews> await_news(const std::function<bool(const HostNews&)>& is_it);
  void give_up(std::string why);

  HostSpec host_;
  std::string name_;  ///< of its log: "host-0"
  HostFolders folders_;
  Pipe to_;
  Pipe from_;
  Pipe wake_;  ///< wakes the thread for what is to be said
  pid_t id_ = 0;
  FrameReader frames_;  ///< the thread's alone

  std::mutex mutex_;  ///< for the rest
  std::condition_variable changed_;
  std::string to_say_;
  std::vector<HostNews> news_;  ///< not yet taken
  Clock::time_point heard_;
  bool greeted_ = false;
  bool closed_ = false;  ///< nothing more will come
  bool over_ = false;    ///< the thread ends
  std::string gone_;
  std::thread thread_;
};

}  // namespace evbal
