#include "tools/ingest/time_pattern.hpp"

#include "tools/records/record_time.hpp"

#include <algorithm>
#include <chrono>

namespace evbal {
namespace {

/// The parts of a time, by the letters of their patterns.
struct TimeParts {
  int year = 1970;
  int month = 1;
  int day = 1;
  int hour = 0;
  int minute = 0;
  int second = 0;

  int* part(char letter) {
    switch (letter) {
      case 'Y':
        return &year;
      case 'm':
        return &month;
      case 'd':
        return &day;
      case 'H':
        return &hour;
      case 'M':
        return &minute;
      case 'S':
        return &second;
      default:
        return nullptr;
    }
  }
};

/// Takes a number of at most `most` digits off the front of `text`.
std::optional<int> take_number(std::string_view& text, std::size_t most) {
  std::size_t digits = 0;
  int number = 0;
  while (digits < std::min(most, text.size()) && text[digits] >= '0' && text[digits] <= '9') {
    number = 10 * number + (text[digits] - '0');
    ++digits;
  }
  text.remove_prefix(digits);
  return digits > 0 ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<long long> time_like(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) {
    return parse_unix_seconds(text);
  }
  TimeParts parts;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    if (pattern[at] == '%' && at + 1 < pattern.size()) {
      int* part = parts.part(pattern[++at]);
      const auto number = take_number(text, pattern[at] == 'Y' ? 4 : 2);
      if (part == nullptr || !number) {
        return std::nullopt;
      }
      *part = *number;
    } else if (text.empty() || text.front() != pattern[at]) {
      return std::nullopt;
    } else {
      text.remove_prefix(1);
    }
  }
  const std::chrono::year_month_day date{std::chrono::year(parts.year),
                                         std::chrono::month(static_cast<unsigned>(parts.month)),
                                         std::chrono::day(static_cast<unsigned>(parts.day))};
  if (!text.empty() || !date.ok() || parts.year < 1970 || parts.hour > 23 || parts.minute > 59 || parts.second > 59) {
    return std::nullopt;
  }
  return std::chrono::sys_days(date).time_since_epoch().count() * 86'400LL + 3600LL * parts.hour + 60LL * parts.minute +
         parts.second;
}

std::string read_time_pattern(const YamlValue& value) {
  std::string text = value.text();
  if (text == "unix") {
    return "";
  }
  TimeParts parts;
  for (std::size_t at = text.find('%'); at != std::string::npos; at = text.find('%', at + 2)) {
    if (at + 1 == text.size() || parts.part(text[at + 1]) == nullptr) {
      throw value.error("`" + text + "` has a % that is none of %Y %m %d %H %M %S");
    }
  }
  for (const char* needed : {"%Y", "%m", "%d", "%H", "%M"}) {
    if (text.find(needed) == std::string::npos) {
      throw value.error("`" + text + "` lacks " + needed + "; expected unix, or a pattern like \"%d/%m/%Y %H:%M\"");
    }
  }
  return text;
}

std::string read_clock_pattern(const YamlValue& value) {
  std::string pattern = read_time_pattern(value);
  if (pattern.empty()) {
    throw value.error("unix seconds are no time that clocks show; expected a pattern like \"%Y-%m-%d %H:%M\"");
  }
  return pattern;
}

std::string time_example(const std::string& pattern) {
  return "`" + (pattern.empty() ? "1709535660" : pattern) + "`";
}

std::vector<std::size_t> add_columns(TableFormat& format, const YamlValue& value) {
  std::vector<std::size_t> columns;
  for (const YamlValue& column : value.is_list() ? value.items() : std::vector<YamlValue>{value}) {
    columns.push_back(add_column(format, column));
  }
  if (columns.empty()) {
    throw value.error("expected a column, or a list of columns that go together");
  }
  return columns;
}

std::optional<long long> time_in(const RawTable& row, const std::vector<std::size_t>& columns, std::string_view pattern,
                                 std::string& text) {
  text.clear();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    text.append(c == 0 ? "" : " ").append(row.text(columns[c]));
  }
  return time_like(pattern, text);
}

}  // namespace evbal
