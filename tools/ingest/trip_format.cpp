#include "tools/ingest/trip_format.hpp"

namespace evbal {
namespace {

TripFormat::End read_end(YamlMap& columns, const std::string& end, bool by_zone, TableFormat& table) {
  TripFormat::End out;
  out.time = add_column(table, columns.require(end + "_time"));
  if (by_zone) {
    out.zone = add_column(table, columns.require(end + "_zone"));
  } else {
    out.lat = add_column(table, columns.require(end + "_lat"));
    out.lon = add_column(table, columns.require(end + "_lon"));
  }
  return out;
}

TripFormat trip_format_of(const YamlValue& value) {
  YamlMap map(value);
  TripFormat format;
  format.table = read_table_format(map);
  if (const auto field = map.find("zone_field")) {
    format.zone_field = field->text();
    if (format.zone_field.empty()) {
      throw field->error("must name a field of the polygons");
    }
  }
  YamlMap columns(map.require("columns"));
  const bool by_zone = !format.zone_field.empty();
  format.pickup = read_end(columns, "pickup", by_zone, format.table);
  format.dropoff = read_end(columns, "dropoff", by_zone, format.table);
  columns.finish();
  format.time_form = read_time_form(map);
  map.finish();
  return format;
}

}  // namespace

TripFormat read_trip_format(const std::filesystem::path& file) {
  return trip_format_of(YamlValue::load(file));
}

TripFormat own_trip_format() {
  return trip_format_of(
      YamlValue::parse("columns: {pickup_time: pickup_unix, pickup_lat: pickup_lat, pickup_lon: pickup_lon,\n"
                       "  dropoff_time: dropoff_unix, dropoff_lat: dropoff_lat, dropoff_lon: dropoff_lon}\n"
                       "time: unix\n",
                       "trips.csv"));
}

}  // namespace evbal
