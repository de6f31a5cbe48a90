#include "tools/ingest/trips.hpp"

#include "agents/world/geometry.hpp"
#include "tools/ingest/trip_rows.hpp"
#include "tools/records/row_tally.hpp"
#include "tools/records/text_lines.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace evbal {
namespace {

/// ISO date of a local time in seconds.
std::string date_of(std::chrono::sys_seconds local) {
  const std::chrono::year_month_day date(std::chrono::floor<std::chrono::days>(local));
  const auto two = [](unsigned number) { return (number < 10 ? "-0" : "-") + std::to_string(number); };
  return std::to_string(static_cast<int>(date.year())) + two(static_cast<unsigned>(date.month())) +
         two(static_cast<unsigned>(date.day()));
}

constexpr std::string_view kOtherDay = "on another day";
constexpr std::string_view kEarly = "before the day's start";

/// Makes trips of rows, or gives the reason why it cannot.
class Sieve {
 public:
  Sieve(const CityNotes& notes, bool by_zone) : notes_(notes), by_zone_(by_zone) {}

  /// Empty if `trip` was filled in, else the reason.
  std::string_view pass(const TripRow& row, Trip& trip) const {
    const std::chrono::sys_seconds local{std::chrono::seconds(notes_.clock.local(row.pickup))};
    const auto& days = notes_.city.days;
    const auto day = std::lower_bound(days.begin(), days.end(), date_of(local));
    if (day == days.end() || *day != date_of(local)) {
      return kOtherDay;
    }
    const auto second = (local - std::chrono::floor<std::chrono::days>(local)).count();
    const int minute = static_cast<int>(second / 60) - notes_.city.day_start;
    if (minute < 0) {
      return kEarly;
    }
    trip.day = static_cast<int>(day - days.begin());
    trip.step = minute / notes_.city.step_minutes;
    trip.from = row.from;
    trip.to = row.to;
    trip.minutes = static_cast<double>(row.dropoff - row.pickup) / 60.0;
    if (trip.minutes < notes_.shortest_minutes) {
      return "too short in time";
    }
    if (trip.minutes > notes_.longest_minutes) {
      return "too long in time";
    }
    const double straight_km = distance(LocalFrame(row.from).local(row.to), {}) / 1000.0;
    trip.km = notes_.detour * straight_km;
    return !by_zone_ && straight_km > notes_.fastest_kmh * trip.minutes / 60.0 ? "too fast" : "";
  }

 private:
  const CityNotes& notes_;
  bool by_zone_;  ///< places are drawn and tell no speed
};

/// Reads the tables one after the other.
class TripReader {
 public:
  TripReader(const TripFormat& format, const std::vector<Zone>& zones, const CityNotes& notes, const UseTrip& use)
      : format_(format), rows_(format, zones, notes.clock), sieve_(notes, !format.zone_field.empty()), use_(use) {}

  void read(const std::filesystem::path& file) {
    RawTable table(file, format_.table);
    RowTally tally(table, count.dropped);
    const long long read_before = count.read;
    const long long used_before = count.used;
    while (table.next()) {
      count.used += tally.keeps(take(table)) ? 1 : 0;
    }
    tally.finish();
    if (count.read > read_before && count.used == used_before) {
      count.first_unused_file = count.unused_files++ > 0 ? count.first_unused_file : file.string();
    }
  }

  RowCount count;

 private:
  RowFault take(const RawTable& table) {
    TripRow row;
    if (const RowFault fault = rows_.read(table, count.read++, row)) {
      return fault;
    }
    Trip trip;
    if (const std::string_view reason = sieve_.pass(row, trip); !reason.empty()) {
      const bool of_start = reason == kOtherDay || reason == kEarly;
      return {reason, (of_start ? rows_.pickup() : rows_.dropoff()).time(table), false};
    }
    if (const std::string_view reason = use_(trip); !reason.empty()) {
      ends_ = rows_.pickup().place(table) + " to " + rows_.dropoff().place(table);
      return {reason, ends_, false};
    }
    return {};
  }

  const TripFormat& format_;
  TripRows rows_;
  Sieve sieve_;
  const UseTrip& use_;
  std::string ends_;  ///< of the trip that was dropped last
};

}  // namespace

std::string RowCount::report() const {
  std::string lines = "rows read: " + std::to_string(read) + "\n" + dropped.report();
  if (unused_files > 0) {
    lines +=
        "  files of which no row is used: " + std::to_string(unused_files) + " (first: " + first_unused_file + ")\n";
  }
  return lines;
}

RowCount for_each_trip(const std::filesystem::path& folder, const TripFormat& format, const std::vector<Zone>& zones,
                       const CityNotes& notes, const UseTrip& use) {
  TripReader reader(format, zones, notes, use);
  try {
    for (const auto& file : text_files(folder)) {
      reader.read(file);
    }
  } catch (const Error& error) {
    throw with_report(error, reader.count.report());
  }
  return std::move(reader.count);
}

}  // namespace evbal
