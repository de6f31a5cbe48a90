#include "tools/ingest/notes.hpp"

#include "agents/world/pack_keys.hpp"
#include "common/yaml.hpp"

namespace evbal {
namespace {

void read_trip_limits(const YamlValue& value, CityNotes& notes) {
  YamlMap map(value);
  notes.shortest_minutes = map.require("shortest").duration();
  notes.longest_minutes = map.require("longest").duration();
  notes.fastest_kmh = map.require("fastest_kmh").number(1.0, 1000.0);
  notes.detour = map.require("detour").number(1.0, 3.0);
  map.finish();
}

void read_zone_limits(const YamlValue& value, CityNotes& notes) {
  YamlMap map(value);
  notes.reach_km = map.require("reach_km").number(1.0, 60.0);
  notes.snap_m = map.require("snap_m").number(0.0, 10'000.0);
  for (const auto& item : map.require("apart").items()) {
    YamlMap apart(item);
    notes.apart.push_back({apart.require("name").text(),
                           {apart.require("lat").number(-90.0, 90.0), apart.require("lon").number(-180.0, 180.0)}});
    apart.finish();
  }
  map.finish();
}

void read_charging_notes(const YamlValue& value, CityNotes& notes) {
  YamlMap map(value);
  notes.city.charging.power_kw = map.require("power_kw").number(0.1, 10'000.0);
  notes.stations = map.require("stations").integer(1, 10'000);
  notes.points = map.require("points").integer(notes.stations, 1'000'000);
  notes.sessions.model = map.require("session_model").text();
  notes.sessions.shortest = map.require("shortest_session").duration();
  notes.sessions.longest = map.require("longest_session").duration();
  map.finish();
}

}  // namespace

CityNotes read_notes(const std::filesystem::path& file) {
  YamlMap map(YamlValue::load(file));
  CityNotes notes;
  notes.city.name = map.require("name").text();
  notes.city.source = map.require("source").text();
  notes.clock = read_local_clock(map);
  read_clock(map, notes.city);
  read_days(map.require("days"), notes.city);
  read_trip_limits(map.require("trips"), notes);
  read_zone_limits(map.require("zones"), notes);
  notes.city.fleet = read_fleet(map.require("fleet"));
  read_charging_notes(map.require("charging"), notes);
  notes.city.passengers = read_passengers(map.require("passengers"));
  map.finish();
  return notes;
}

}  // namespace evbal
