#pragma once

#include "tools/records/local_clock.hpp"

#include <optional>
#include <string_view>

namespace evbal {

/// The form of a time in tables of records.
enum class TimeForm {
  unix_seconds,  ///< since 1970-01-01 00:00 UTC
  utc,           ///< "2008-05-18 07:31:05"
  local,         ///< the same as clocks show it
};

/// Reads the key `time`: unix, utc or local.
TimeForm read_time_form(YamlMap& map);

/// What a time of this form is, for messages: "time written as 2008-05-18 07:31:05".
std::string_view example_of(TimeForm form);

/// The reason under which rows are counted that tell a local time which clocks never showed.
inline constexpr const char* skipped_time = "at a local time that the clocks skipped";

/// Whole seconds since 1970 up to the year 9999, which some programs write 1211137200.0; nothing if the text is none.
std::optional<long long> parse_unix_seconds(std::string_view text);

/// How the reading of a time ended.
enum class TimeReading {
  done,
  unreadable,  ///< it is no time of this form
  skipped,     ///< clocks never showed it: skipped_time
};

/// Puts UTC seconds into `time`; a local time that clocks show twice is the first one after `after`.
TimeReading read_record_time(std::string_view text, TimeForm form, const LocalClock& clock, long long after,
                             long long& time);

}  // namespace evbal
