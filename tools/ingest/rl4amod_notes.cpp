#include "tools/ingest/rl4amod_notes.hpp"

#include "agents/world/pack_keys.hpp"

namespace evbal {
namespace {

void read_rl4amod_charging(const YamlValue& value, Rl4amodNotes& notes) {
  YamlMap map(value);
  notes.stations = map.require("stations").integer(1, 1000);
  notes.points = map.require("points").integer(notes.stations, 1'000'000);
  notes.city.charging = read_charging(map);
  map.finish();
}

}  // namespace

Rl4amodNotes read_rl4amod_notes(const std::filesystem::path& file) {
  YamlMap map(YamlValue::load(file));
  Rl4amodNotes notes;
  notes.city.name = map.require("name").text();
  notes.city.source = map.require("source").text();
  const YamlValue step = map.require("step");
  notes.city.step_minutes = step.whole_minutes();
  if (60 % notes.city.step_minutes != 0) {
    throw step.error("step must divide an hour");
  }
  read_days(map.require("days"), notes.city);
  notes.demand_ratio = map.require("demand_ratio").number(0.0, 1000.0);
  notes.seed = map.require("seed").seed();
  notes.kmh = map.require("kmh").number(1.0, 200.0);
  notes.city.fleet = read_fleet(map.require("fleet"));
  read_rl4amod_charging(map.require("charging"), notes);
  notes.city.passengers = read_passengers(map.require("passengers"));
  map.finish();
  return notes;
}

}  // namespace evbal
