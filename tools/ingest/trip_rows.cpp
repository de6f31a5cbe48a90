#include "tools/ingest/trip_rows.hpp"

#include "tools/records/dropped.hpp"
#include "tools/records/record_place.hpp"

#include <limits>

namespace evbal {

TripEndColumns::TripEndColumns(const TripFormat& format, const TripFormat::End& end, const std::vector<Zone>& zones)
    : format_(format),
      end_(end),
      no_time_(column_name(format.table, end.time) + " is no " + std::string(example_of(format.time_form))) {
  if (format.zone_field.empty()) {
    no_lat_ = column_name(format.table, end.lat) + " is no latitude in degrees, -90 to 90";
    no_lon_ = column_name(format.table, end.lon) + " is no longitude in degrees, -180 to 180";
  } else {
    no_zone_ = "in a zone without polygon: " + column_name(format.table, end.zone) + " is no `" + format.zone_field +
               "`, such as " + shown(zones.front().name);
  }
}

RowFault TripEndColumns::read_time(const RawTable& table, const LocalClock& clock, long long after,
                                   long long& time) const {
  const std::string_view text = table.text(end_.time);
  switch (read_record_time(text, format_.time_form, clock, after, time)) {
    case TimeReading::done:
      return {};
    case TimeReading::unreadable:
      return {no_time_, text};
    case TimeReading::skipped:
      return {skipped_time, text, false};
  }
  return {};
}

RowFault TripEndColumns::read_place(const RawTable& table, const ZonePlaces& zones, std::uint64_t draw,
                                    LatLon& place) const {
  if (!format_.zone_field.empty()) {
    const std::string_view name = table.text(end_.zone);
    const auto found = zones.place(name, draw);
    place = found.value_or(place);
    return found ? RowFault{} : RowFault{no_zone_, name, false};
  }
  return evbal::read_place(table, end_.lat, end_.lon, place, no_lat_, no_lon_);
}

std::string TripEndColumns::place(const RawTable& table) const {
  return format_.zone_field.empty() ? std::string(table.text(end_.lat)) + " " + std::string(table.text(end_.lon))
                                    : std::string(table.text(end_.zone));
}

TripRows::TripRows(const TripFormat& format, const std::vector<Zone>& zones, const LocalClock& clock)
    : pickup_(format, format.pickup, zones),
      dropoff_(format, format.dropoff, zones),
      zones_(zones, format.table.decimal_comma ? ',' : '.'),
      clock_(clock) {}

RowFault TripRows::read(const RawTable& table, long long number, TripRow& row) const {
  const auto draw = 2 * static_cast<std::uint64_t>(number);
  RowFault fault = table.fault();
  fault = fault ? fault : pickup_.read_time(table, clock_, std::numeric_limits<long long>::min(), row.pickup);
  fault = fault ? fault : dropoff_.read_time(table, clock_, row.pickup - 1, row.dropoff);
  fault = fault ? fault : pickup_.read_place(table, zones_, draw, row.from);
  return fault ? fault : dropoff_.read_place(table, zones_, draw + 1, row.to);
}

}  // namespace evbal
