#pragma once

#include "tools/records/raw_table.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// Seconds since 1970, as if UTC, of a time in which %Y %m %d %H %M %S stand for numbers and all else for itself; a
/// part that the pattern lacks is 0, or 1 for month and day. An empty pattern stands for unix seconds. Nothing if
/// `text` is no such time from 1970 to 9999.
std::optional<long long> time_like(std::string_view pattern, std::string_view text);

/// Reads a pattern that tells the minute at least, or the word `unix`, which is an empty pattern.
std::string read_time_pattern(const YamlValue& value);

/// Reads a pattern that tells the minute at least, of times as clocks show them.
std::string read_clock_pattern(const YamlValue& value);

/// A time of this pattern as messages show it.
std::string time_example(const std::string& pattern);

/// Appends the column, or the list of columns, that `value` names (add_column).
std::vector<std::size_t> add_columns(TableFormat& format, const YamlValue& value);

/// The time in the fields of these columns, read with a blank between as time_like() does. They are put into `text`,
/// for messages.
std::optional<long long> time_in(const RawTable& row, const std::vector<std::size_t>& columns, std::string_view pattern,
                                 std::string& text);

}  // namespace evbal
