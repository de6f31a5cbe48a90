#include "tools/ingest/trips.hpp"

#include "agents/city/geometry.hpp"
#include "agents/city/table.hpp"
#include "tools/records/lines.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace evbal {
namespace {

const std::string kHeader = "cab,pickup_unix,pickup_lat,pickup_lon,dropoff_unix,dropoff_lat,dropoff_lon";
constexpr long long kLastSecond = 253'402'300'799;  // year 9999

struct Row {
  long long pickup = 0;  ///< UTC seconds
  long long dropoff = 0;
  LatLon from;
  LatLon to;
};

std::optional<LatLon> parse_point(const std::string& lat_text, const std::string& lon_text) {
  const auto lat = parse_number(lat_text);
  const auto lon = parse_number(lon_text);
  const bool sound = lat && lon && std::abs(*lat) <= 90.0 && std::abs(*lon) <= 180.0;
  return sound ? std::optional(LatLon{*lat, *lon}) : std::nullopt;
}

std::optional<long long> parse_time(const std::string& text) {
  const auto seconds = parse_integer(text);
  return seconds && *seconds >= 0 && *seconds <= kLastSecond ? seconds : std::nullopt;
}

std::optional<Row> parse_row(const std::string& line) {
  const auto fields = split_csv(line);
  if (fields.size() != 7) {
    return std::nullopt;
  }
  const auto pickup = parse_time(fields[1]);
  const auto dropoff = parse_time(fields[4]);
  const auto from = parse_point(fields[2], fields[3]);
  const auto to = parse_point(fields[5], fields[6]);
  if (!pickup || !dropoff || !from || !to) {
    return std::nullopt;
  }
  return Row{*pickup, *dropoff, *from, *to};
}

/// ISO date of a local time in seconds.
std::string date_of(std::chrono::sys_seconds local) {
  const std::chrono::year_month_day date(std::chrono::floor<std::chrono::days>(local));
  const auto two = [](unsigned number) { return (number < 10 ? "-0" : "-") + std::to_string(number); };
  return std::to_string(static_cast<int>(date.year())) + two(static_cast<unsigned>(date.month())) +
         two(static_cast<unsigned>(date.day()));
}

/// Makes trips of rows, or says why not.
class Sieve {
 public:
  explicit Sieve(const CityNotes& notes) : notes_(notes) {}

  /// Empty if `trip` was filled in, else the reason.
  std::string pass(const Row& row, Trip& trip) const {
    const std::chrono::sys_seconds local{std::chrono::seconds(row.pickup + 60LL * notes_.utc_offset)};
    const auto& days = notes_.city.days;
    const auto day = std::lower_bound(days.begin(), days.end(), date_of(local));
    if (day == days.end() || *day != date_of(local)) {
      return "on another day";
    }
    const auto second = (local - std::chrono::floor<std::chrono::days>(local)).count();
    const int minute = static_cast<int>(second / 60) - notes_.city.day_start;
    if (minute < 0) {
      return "before the day's start";
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
    return straight_km > notes_.fastest_kmh * trip.minutes / 60.0 ? "too fast" : "";
  }

 private:
  const CityNotes& notes_;
};

}  // namespace

RowCount for_each_trip(const std::filesystem::path& folder, const CityNotes& notes,
                       const std::function<void(const Trip&)>& use) {
  const Sieve sieve(notes);
  RowCount count;
  std::string line;
  for (const auto& file : csv_files(folder)) {
    LineReader lines(file);
    if (!lines.next(line) || line != kHeader) {
      throw lines.error("the first line must be `" + kHeader + "`");
    }
    while (lines.next(line)) {
      ++count.read;
      Trip trip;
      const auto row = parse_row(line);
      const std::string reason = row ? sieve.pass(*row, trip) : "malformed row";
      if (reason.empty()) {
        ++count.used;
        use(trip);
      } else {
        ++count.dropped[reason];
      }
    }
  }
  return count;
}

}  // namespace evbal
