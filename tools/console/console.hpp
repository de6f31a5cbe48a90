#pragma once

#include "experiments/run/day_door.hpp"
#include "experiments/run/twins.hpp"
#include "tools/console/feed.hpp"
#include "tools/console/web_server.hpp"

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// The page on which a day is watched and broken by hand, served while `evbal run` plays it. Nothing of it waits for a
/// browser.
class Console {
 public:
  /// Serves on a port of the loopback interface, on any that is free for 0. Throws Error{run_failed} if it is taken.
  explicit Console(int port);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// Where the page is, with its token.
  std::string link() const { return server_.link(); }

  /// A day begins, which is recorded in `folder`.
  void begin(const Scenario& scenario, const std::filesystem::path& folder);

  /// A tick of it is over.
  void add(const TickRecord& record);

  /// A fault was added to it.
  void add_fault(const Fault& fault);

  /// How it goes on.
  void note_pace(const DayPace& pace);

  /// What the same day without faults has come to.
  void add_twin(const std::vector<DayTally>& ticks);

 private:
  std::string ask(const std::string& request) const;

  Feed feed_;
  mutable std::mutex mutex_;
  std::filesystem::path folder_;  ///< of the day
  std::vector<std::string> fault_names_;
  DayTally so_far_;
  std::optional<TickRecord> last_;
  WebServer server_;
};

}  // namespace evbal
