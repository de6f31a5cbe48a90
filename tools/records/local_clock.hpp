#pragma once

#include "common/yaml.hpp"

#include <string_view>
#include <vector>

namespace evbal {

/// How far a place's clocks are ahead of UTC, which daylight saving changes. Times are seconds since 1970-01-01 00:00,
/// UTC or as the clocks show.
class LocalClock {
 public:
  /// Clocks that are set forward or back.
  struct Change {
    long long utc = 0;  ///< seconds, from which it holds
    int minutes = 0;    ///< that clocks are ahead of UTC
  };

  /// `minutes` up to the first change; changes ascend and are more than a day apart.
  explicit LocalClock(int minutes, std::vector<Change> changes = {});

  /// What clocks show at `utc`.
  long long local(long long utc) const { return utc + 60LL * minutes_at(utc); }

  /// When clocks show `local`, ascending: never in the hour that daylight saving skips, twice in the one that it
  /// repeats.
  std::vector<long long> utc(long long local) const;

  /// The first of them after `after`, else the last; nothing if there is none.
  std::optional<long long> utc_after(long long local, long long after) const;

 private:
  int minutes_at(long long utc) const;

  int minutes_;
  std::vector<Change> changes_;
};

/// Seconds since 1970 of "2008-05-18 07:31:05" (or with a T), as if UTC; nothing if it is no such time.
std::optional<long long> parse_time(std::string_view text);

/// Reads `utc_offset_minutes` and, if given, `clock_changes`: a list of
/// {utc: "2008-11-02 09:00:00", utc_offset_minutes: -480}.
LocalClock read_local_clock(YamlMap& map);

}  // namespace evbal
