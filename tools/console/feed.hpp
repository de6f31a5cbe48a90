#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace evbal {

/// What is told of a day, for any number of readers, who come and go in threads of their own. Who tells never waits for
/// a reader: texts are kept until the next day begins, and each reader goes on from where it is. All is said as
/// server-sent events, of one line of JSON each.
class Feed {
 public:
  /// Where a reader is.
  struct Place {
    int day = 0;            ///< that it has heard of
    std::size_t event = 0;  ///< that comes next
    int state = 0;          ///< that it has heard
  };

  /// A day begins, of which `json` says what does not change; what was told before is forgotten.
  void begin_day(const std::string& json);

  /// Tells an event, named `kind`, which every reader will hear.
  void tell(const std::string& kind, const std::string& json);

  /// Tells how things stand: of several, readers hear the newest only. The same again is not told.
  void tell_state(const std::string& json);

  /// Nothing more will be told.
  void close();

  /// What the reader has not heard yet, as much as is sent at once; waits for it at most so long and is empty then, or
  /// if nothing more comes.
  std::string next(Place& place, std::chrono::milliseconds at_most);

  /// Whether nothing more will be told, and a reader at this place has heard all.
  bool over(const Place& place) const;

 private:
  bool heard_all(const Place& place) const;

  mutable std::mutex mutex_;
  std::condition_variable told_;
  int days_ = 0;
  std::vector<std::string> events_;  ///< of the day; the first says what it is
  std::string state_;
  int states_ = 0;
  bool closed_ = false;
};

}  // namespace evbal
