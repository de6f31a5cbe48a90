#include "tools/ingest/count_notes.hpp"

#include "agents/world/pack_keys.hpp"
#include "tools/ingest/time_pattern.hpp"

namespace evbal {
namespace {

void read_counts_part(const YamlValue& value, CountNotes& notes) {
  YamlMap map(value);
  CountFormat& format = notes.counts;
  format.table = read_table_format(map);
  YamlMap columns(map.require("columns"));
  format.time = add_columns(format.table, columns.require("time"));
  format.from = add_column(format.table, columns.require("from"));
  format.to = add_column(format.table, columns.require("to"));
  format.trips = add_column(format.table, columns.require("trips"));
  columns.finish();
  format.pattern = read_clock_pattern(map.require("time"));
  notes.zone_field = map.require("zone_field").text();
  notes.choice.share = map.require("share").number(0.0001, 1.0);
  notes.choice.seed = map.require("seed").seed();
  map.finish();
}

void read_sample_part(const YamlValue& value, SampleFormat& format) {
  YamlMap map(value);
  format.table = read_table_format(map);
  YamlMap columns(map.require("columns"));
  format.start = add_columns(format.table, columns.require("start"));
  format.end = add_columns(format.table, columns.require("end"));
  format.from = add_column(format.table, columns.require("from"));
  format.to = add_column(format.table, columns.require("to"));
  format.distance = add_column(format.table, columns.require("distance"));
  columns.finish();
  format.pattern = read_clock_pattern(map.require("time"));
  format.km = map.require("km").number(0.0001, 10.0);
  format.shortest = map.require("shortest").duration();
  format.longest = map.require("longest").duration();
  format.fastest_kmh = map.require("fastest_kmh").number(1.0, 1000.0);
  map.finish();
}

void read_stations_part(const YamlValue& value, CountNotes& notes) {
  YamlMap map(value);
  notes.stations = read_fleet_stations(map, notes.city);
  notes.snap_m = map.require("snap_m").number(0.0, 10'000.0);
  map.finish();
}

void read_sessions_part(const YamlValue& value, CountNotes& notes) {
  YamlMap map(value);
  notes.session_table = read_session_format(map);
  notes.sessions.model = map.require("model").text();
  notes.sessions.shortest = map.require("shortest").duration();
  notes.sessions.longest = map.require("longest").duration();
  map.finish();
}

}  // namespace

CountNotes read_count_notes(const std::filesystem::path& file) {
  YamlMap map(YamlValue::load(file));
  CountNotes notes;
  notes.city.name = map.require("name").text();
  notes.city.source = map.require("source").text();
  read_clock(map, notes.city);
  read_days(map.require("days"), notes.city);
  read_counts_part(map.require("counts"), notes);
  read_sample_part(map.require("sample"), notes.sample);
  notes.city.fleet = read_fleet(map.require("fleet"));
  read_stations_part(map.require("stations"), notes);
  read_sessions_part(map.require("sessions"), notes);
  notes.city.passengers = read_passengers(map.require("passengers"));
  map.finish();
  notes.choice.days = notes.city.days;
  notes.choice.day_start = notes.city.day_start;
  notes.choice.step_minutes = notes.city.step_minutes;
  return notes;
}

}  // namespace evbal
