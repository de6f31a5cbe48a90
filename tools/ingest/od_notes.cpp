#include "tools/ingest/od_notes.hpp"

#include "agents/world/pack_keys.hpp"

namespace evbal {
namespace {

OdFormat read_od_format(const YamlValue& value) {
  YamlMap map(value);
  OdFormat format;
  format.table = read_table_format(map);
  YamlMap columns(map.require("columns"));
  format.from_lat = add_column(format.table, columns.require("from_lat"));
  format.from_lon = add_column(format.table, columns.require("from_lon"));
  format.to_lat = add_column(format.table, columns.require("to_lat"));
  format.to_lon = add_column(format.table, columns.require("to_lon"));
  format.trips = add_column(format.table, columns.require("trips"));
  columns.finish();
  if (const auto grid = map.find("grid")) {
    YamlMap cells(*grid);
    format.first = {cells.require("lat").number(-90.0, 90.0), cells.require("lon").number(-180.0, 180.0)};
    format.step = {cells.require("lat_step").number(1e-5, 1.0), cells.require("lon_step").number(1e-5, 1.0)};
    cells.finish();
  }
  map.finish();
  return format;
}

void read_travel(const YamlValue& value, CityFactors& factors) {
  YamlMap map(value);
  factors.detour = map.require("detour").number(1.0, 3.0);
  factors.start_minutes = map.require("start").duration();
  factors.minutes_per_km = map.require("minutes_per_km").number(0.0, 60.0);
  map.finish();
}

}  // namespace

OdNotes read_od_notes(const std::filesystem::path& file) {
  YamlMap map(YamlValue::load(file));
  OdNotes notes;
  CityFactors& factors = notes.city.factors.emplace();
  notes.city.name = map.require("name").text();
  notes.city.source = map.require("source").text();
  notes.trips = read_od_format(map.require("trips"));
  factors.seed = map.require("seed").seed();
  factors.share = map.require("share").number(0.0, 1.0);
  notes.within_day = map.require("within_day").number(0.0, 1.0);
  read_travel(map.require("travel"), factors);
  notes.snap_m = map.require("snap_m").number(0.0, 10'000.0);
  notes.city.fleet = read_fleet(map.require("fleet"));
  YamlMap stations(map.require("stations"));
  notes.stations = read_fleet_stations(stations, notes.city);
  stations.finish();
  notes.city.passengers = read_passengers(map.require("passengers"));
  map.finish();
  return notes;
}

}  // namespace evbal
