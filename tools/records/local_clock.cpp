#include "tools/records/local_clock.hpp"

#include "agents/world/pack_table.hpp"

#include <algorithm>
#include <chrono>

namespace evbal {
namespace {

constexpr int kMostMinutes = 14 * 60;
constexpr long long kDay = 24 * 3600;

/// The digits text[at .. at + length) as a number, -1 if they are none.
int digits(std::string_view text, std::size_t at, std::size_t length) {
  int number = 0;
  for (const char c : text.substr(at, length)) {
    if (c < '0' || c > '9') {
      return -1;
    }
    number = 10 * number + (c - '0');
  }
  return number;
}

}  // namespace

LocalClock::LocalClock(int minutes, std::vector<Change> changes) : minutes_(minutes), changes_(std::move(changes)) {}

int LocalClock::minutes_at(long long utc) const {
  const auto after = std::upper_bound(changes_.begin(), changes_.end(), utc,
                                      [](long long at, const Change& change) { return at < change.utc; });
  return after == changes_.begin() ? minutes_ : std::prev(after)->minutes;
}

std::vector<long long> LocalClock::utc(long long local_time) const {
  std::vector<long long> found;
  const auto try_minutes = [&](int minutes) {
    const long long candidate = local_time - 60LL * minutes;
    if (local(candidate) == local_time && (found.empty() || found.back() != candidate)) {
      found.push_back(candidate);
    }
  };
  try_minutes(minutes_at(local_time - kDay));
  try_minutes(minutes_at(local_time + kDay));
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<long long> LocalClock::utc_after(long long local, long long after) const {
  const auto possible = utc(local);
  if (possible.empty()) {
    return std::nullopt;
  }
  const auto later = std::upper_bound(possible.begin(), possible.end(), after);
  return later == possible.end() ? possible.back() : *later;
}

std::optional<long long> parse_time(std::string_view text) {
  if (text.size() != 19 || text[4] != '-' || text[7] != '-' || (text[10] != ' ' && text[10] != 'T') ||
      text[13] != ':' || text[16] != ':') {
    return std::nullopt;
  }
  const int year = digits(text, 0, 4);
  const int month = digits(text, 5, 2);
  const int day = digits(text, 8, 2);
  const int hour = digits(text, 11, 2);
  const int minute = digits(text, 14, 2);
  const int second = digits(text, 17, 2);
  if (std::min({year, month, day, hour, minute, second}) < 0 || hour > 23 || minute > 59 || second > 59) {
    return std::nullopt;
  }
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) {
    return std::nullopt;
  }
  return std::chrono::sys_days(date).time_since_epoch().count() * kDay + 3600LL * hour + 60LL * minute + second;
}

LocalClock read_local_clock(YamlMap& map) {
  const int minutes = map.require("utc_offset_minutes").integer(-kMostMinutes, kMostMinutes);
  std::vector<LocalClock::Change> changes;
  if (const auto list = map.find("clock_changes")) {
    for (const auto& item : list->items()) {
      YamlMap change(item);
      const YamlValue when = change.require("utc");
      const auto utc = parse_time(when.text());
      if (!utc) {
        throw when.error("`" + when.text() + "` is no time; write it like \"2008-11-02 09:00:00\"");
      }
      if (!changes.empty() && *utc <= changes.back().utc + kDay) {
        throw when.error("must come more than a day after the change before it");
      }
      changes.push_back({*utc, change.require("utc_offset_minutes").integer(-kMostMinutes, kMostMinutes)});
      change.finish();
    }
  }
  return LocalClock(minutes, std::move(changes));
}

}  // namespace evbal
