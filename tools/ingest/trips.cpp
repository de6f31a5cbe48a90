#include "tools/ingest/trips.hpp"

#include "agents/world/geometry.hpp"
#include "agents/world/pack_table.hpp"
#include "tools/ingest/zone_places.hpp"
#include "tools/records/text_lines.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace evbal {
namespace {

constexpr long long kRowsToJudge = 100;  // if so many first rows are malformed, the format is wrong

struct Row {
  long long pickup = 0;  ///< UTC seconds
  long long dropoff = 0;
  LatLon from;
  LatLon to;
};

/// Reads the rows of tables, or gives the reason why it cannot.
class RowReader {
 public:
  RowReader(const TripFormat& format, const std::vector<Zone>& zones, const LocalClock& clock)
      : format_(format), zones_(zones), clock_(clock) {}

  /// Null if `row` was filled in, else the reason. `number` is the row's, which places in zones are drawn by.
  const char* read(const RawTable& table, long long number, Row& row) const {
    if (!table.whole()) {
      return malformed_row;
    }
    const char* reason = read_record_time(table.text(format_.pickup.time), format_.time_form, clock_,
                                          std::numeric_limits<long long>::min(), row.pickup);
    reason = reason ? reason
                    : read_record_time(table.text(format_.dropoff.time), format_.time_form, clock_, row.pickup - 1,
                                       row.dropoff);
    reason = reason ? reason : read_place(table, format_.pickup, 2 * number, row.from);
    return reason ? reason : read_place(table, format_.dropoff, 2 * number + 1, row.to);
  }

 private:
  const char* read_place(const RawTable& table, const TripFormat::End& end, long long draw, LatLon& place) const {
    if (!format_.zone_field.empty()) {
      const auto found = zones_.place(table.text(end.zone), static_cast<std::uint64_t>(draw));
      place = found.value_or(place);
      return found ? nullptr : "in a zone without polygon";
    }
    const auto lat = parse_number(table.text(end.lat));
    const auto lon = parse_number(table.text(end.lon));
    if (!lat || !lon || std::abs(*lat) > 90.0 || std::abs(*lon) > 180.0) {
      return malformed_row;
    }
    place = {*lat, *lon};
    return nullptr;
  }

  const TripFormat& format_;
  ZonePlaces zones_;
  const LocalClock& clock_;
};

/// ISO date of a local time in seconds.
std::string date_of(std::chrono::sys_seconds local) {
  const std::chrono::year_month_day date(std::chrono::floor<std::chrono::days>(local));
  const auto two = [](unsigned number) { return (number < 10 ? "-0" : "-") + std::to_string(number); };
  return std::to_string(static_cast<int>(date.year())) + two(static_cast<unsigned>(date.month())) +
         two(static_cast<unsigned>(date.day()));
}

/// Makes trips of rows, or gives the reason why it cannot.
class Sieve {
 public:
  Sieve(const CityNotes& notes, bool by_zone) : notes_(notes), by_zone_(by_zone) {}

  /// Empty if `trip` was filled in, else the reason.
  std::string pass(const Row& row, Trip& trip) const {
    const std::chrono::sys_seconds local{std::chrono::seconds(notes_.clock.local(row.pickup))};
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
    return !by_zone_ && straight_km > notes_.fastest_kmh * trip.minutes / 60.0 ? "too fast" : "";
  }

 private:
  const CityNotes& notes_;
  bool by_zone_;  ///< places are drawn and tell no speed
};

}  // namespace

RowCount for_each_trip(const std::filesystem::path& folder, const TripFormat& format, const std::vector<Zone>& zones,
                       const CityNotes& notes, const std::function<void(const Trip&)>& use) {
  const RowReader reader(format, zones, notes.clock);
  const Sieve sieve(notes, !format.zone_field.empty());
  RowCount count;
  for (const auto& file : text_files(folder)) {
    RawTable table(file, format.table);
    long long rows = 0;
    long long malformed = 0;
    while (table.next()) {
      ++rows;
      Row row;
      Trip trip;
      const char* unread = reader.read(table, count.read++, row);
      const std::string reason = unread ? unread : sieve.pass(row, trip);
      if (reason.empty()) {
        ++count.used;
        use(trip);
        continue;
      }
      ++count.dropped[reason];
      malformed += reason == malformed_row ? 1 : 0;
      if (rows == kRowsToJudge && malformed == rows) {
        throw table.error("and all rows before it are malformed; is the description of this table?");
      }
    }
  }
  return count;
}

}  // namespace evbal
