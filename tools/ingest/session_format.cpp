#include "tools/ingest/session_format.hpp"

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

std::vector<std::size_t> add_columns(TableFormat& table, const YamlValue& value) {
  std::vector<std::size_t> columns;
  for (const YamlValue& column : value.is_list() ? value.items() : std::vector<YamlValue>{value}) {
    columns.push_back(add_column(table, column));
  }
  if (columns.empty()) {
    throw value.error("expected a column, or a list of columns that tell a time together");
  }
  return columns;
}

std::string read_time(const YamlValue& value) {
  const std::string text = value.text();
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

SessionFormat session_format_of(const YamlValue& value) {
  YamlMap map(value);
  SessionFormat format;
  format.table = read_table_format(map);
  YamlMap columns(map.require("columns"));
  format.start = add_columns(format.table, columns.require("start"));
  format.end = add_columns(format.table, columns.require("end"));
  if (const auto charger = columns.find("charger")) {
    format.charger = add_column(format.table, *charger);
  }
  columns.finish();
  format.time = read_time(map.require("time"));
  map.finish();
  return format;
}

}  // namespace

std::optional<long long> time_like(std::string_view pattern, std::string_view text) {
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
  if (!text.empty() || !date.ok() || parts.hour > 23 || parts.minute > 59 || parts.second > 59) {
    return std::nullopt;
  }
  return std::chrono::sys_days(date).time_since_epoch().count() * 86'400LL + 3600LL * parts.hour + 60LL * parts.minute +
         parts.second;
}

SessionFormat read_session_format(const std::filesystem::path& file) {
  return session_format_of(YamlValue::load(file));
}

SessionFormat dundee_session_format() {
  return session_format_of(
      YamlValue::parse("columns: {start: [Start Date, Start Time], end: [End Date, End Time], charger: Model}\n"
                       "time: \"%d/%m/%Y %H:%M\"\n",
                       "dundee.yaml"));
}

}  // namespace evbal
