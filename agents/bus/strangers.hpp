#pragma once

#include "agents/bus/roster.hpp"

#include <chrono>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace evbal {

/// Keeps an account of those on a bus with security who do not prove that they belong to the run, and whom the
/// middleware therefore keeps out. Without security there are none. From any thread.
class Strangers {
 public:
  /// By which time to prove is measured; of no consequence for the day.
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds time_to_prove{10};  ///< after which who has not proved itself is a stranger
  static constexpr std::size_t most_named = 100;            ///< between two calls of named(), so that none floods us

  /// `roster` must outlive this.
  explicit Strangers(const Roster& roster) : roster_(roster) {}

  /// A participant announces itself, under a name of its own choice.
  void seen(const GuidPrefix& who, const std::string& name, Clock::time_point now = Clock::now());
  /// It has proved that its certificate and its grant are genuine.
  void proved(const GuidPrefix& who);
  /// It has tried and failed. Fast DDS 3 tells first who proves itself, and does not say what the others call
  /// themselves.
  void failed(const GuidPrefix& who, Clock::time_point now = Clock::now());
  /// It is gone.
  void left(const GuidPrefix& who);

  /// Who has turned out to be a stranger since the last call, in a few words each.
  std::vector<std::string> named(Clock::time_point now = Clock::now());

 private:
  struct Unproved {
    std::string name{};
    Clock::time_point since;
    bool failed = false;
    bool named = false;
  };

  void name(const GuidPrefix& who, Unproved& stranger);

  const Roster& roster_;
  std::mutex mutex_;
  std::map<GuidPrefix, Unproved> unproved_;
  std::set<GuidPrefix> proved_;
  std::vector<std::string> found_;
  std::size_t unnamed_ = 0;  ///< beyond most_named
};

}  // namespace evbal
