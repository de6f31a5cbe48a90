// What libFuzzer calls: any bytes as tables of records of each kind.

#include "agents/world/factors.hpp"
#include "agents/world/regions_file.hpp"
#include "tests/fuzz/any_bytes.hpp"
#include "tools/fit/transition_table.hpp"
#include "tools/gps/ingest_gps.hpp"
#include "tools/ingest/cell_trips.hpp"
#include "tools/ingest/rl4amod_scenario.hpp"
#include "tools/ingest/sessions.hpp"
#include "tools/ingest/travel_sample.hpp"
#include "tools/ingest/trips.hpp"
#include "tools/ingest/zone_counts.hpp"

namespace evbal {
namespace {

namespace fs = std::filesystem;

void read_gps(std::string_view bytes) {
  static const fs::path format = write("gps.yaml",
                                       "separator: space\nheader: false\nvehicle_in_name: \"*.txt\"\n"
                                       "columns: {lat: 1, lon: 2, occupied: 3, time: 4}\ntime: unix\noccupied: \"1\"\n"
                                       "free: \"0\"\nutc_offset_minutes: -420\n");
  static const fs::path regions_file = write("regions.geojson", regions_geojson(regions()));
  static const fs::path stations =
      write("stations.yaml", "stations: [{name: s, region: a, points: 1, lat: 37.75, lon: -122.45}]\n");
  write("gps/cab.txt", bytes);
  ingest_gps({folder() / "gps", format, regions_file, stations}, folder() / "out", [](const FixProgress&) {});
}

void read_local_gps(std::string_view bytes) {
  static const fs::path format = write("local.yaml",
                                       "columns: {vehicle: v, lat: a, lon: o, occupied: m, time: t}\ntime: local\n"
                                       "occupied: \"1\"\nfree: \"0\"\nutc_offset_minutes: -420\n"
                                       "clock_changes: [{utc: \"2008-11-02 09:00:00\", utc_offset_minutes: -480}]\n");
  write("local/cabs.csv", bytes);
  for_each_fix(
      folder() / "local", read_gps_format(format), [](const std::string&, const Fix&, bool) {},
      [](const FixProgress&) {});
}

void read_trip_table(std::string_view bytes) {
  CityNotes notes;
  notes.city.days = {"2008-05-18"};
  write("trips/trips.csv", bytes);
  for_each_trip(folder() / "trips", own_trip_format(), {}, notes, [](const Trip&) -> std::string_view { return {}; });
}

void read_trips_by_zone(std::string_view bytes) {
  static const TripFormat format = read_trip_format(write(
      "trips.yaml",
      "columns: {pickup_time: p, dropoff_time: d, pickup_zone: f, dropoff_zone: t}\ntime: local\nzone_field: id\n"));
  static const std::vector<Zone> zones =
      read_zones(write("zones.geojson", R"({"features": [{"properties": {"id": 1}, "geometry": {"type": "Polygon",)"
                                        R"( "coordinates": [[[114, 22], [114.1, 22], [114, 22.1], [114, 22]]]}}]})"),
                 {.name = "id", .weight = {}})
          .zones;
  CityNotes notes;
  notes.city.days = {"2008-11-02"};
  notes.clock = LocalClock(-420, {{1225616400, -480}});
  write("trips/trips.csv", bytes);
  for_each_trip(folder() / "trips", format, zones, notes, [](const Trip&) -> std::string_view { return {}; });
}

void read_session_table(std::string_view bytes) {
  write("sessions/sessions.csv", bytes);
  read_sessions(folder() / "sessions", dundee_session_format(), {"Rapid", 1.0, 100.0});
}

void read_transition_table(std::string_view bytes) {
  read_transitions(write("transitions.csv", bytes), regions());
}

const std::vector<Zone>& two_zones() {
  static const std::vector<Zone> zones =
      read_zones(write("two.geojson", R"({"features": [{"properties": {"id": 1}, "geometry": {"type": "Polygon",)"
                                      R"( "coordinates": [[[114, 22], [114.1, 22], [114, 22.1], [114, 22]]]}},)"
                                      R"( {"properties": {"id": 2}, "geometry": {"type": "Polygon",)"
                                      R"( "coordinates": [[[114, 23], [114.1, 23], [114, 23.1], [114, 23]]]}}]})"),
                 {.name = "id", .weight = {}})
          .zones;
  return zones;
}

void read_count_table(std::string_view bytes) {
  CountFormat format;
  format.table.columns = {"date", "time", "from", "to", "trips"};
  format.time = {0, 1};
  format.pattern = "%Y-%m-%d %H:%M";
  format.from = 2;
  format.to = 3;
  format.trips = 4;
  write("counts/a.csv", bytes);
  read_counts(folder() / "counts", format, two_zones(),
              {.days = {"2019-03-03"}, .day_start = 300, .step_minutes = 60, .share = 0.5, .seed = 1});
}

void read_sample_table(std::string_view bytes) {
  SampleFormat format;
  format.table.columns = {"begin", "end", "from", "to", "km"};
  format.start = {0};
  format.end = {1};
  format.pattern = "%Y-%m-%d %H:%M:%S";
  format.from = 2;
  format.to = 3;
  format.distance = 4;
  fit_travel(write("sample.csv", bytes), format, two_zones(),
             [](int from, int to) { return from == to ? 1.0 : 100.0; });
}

void read_cell_table(std::string_view bytes) {
  OdFormat format;
  format.table.columns = {"from_lat", "from_lon", "to_lat", "to_lon", "trips"};
  format.from_lat = 0;
  format.from_lon = 1;
  format.to_lat = 2;
  format.to_lon = 3;
  format.trips = 4;
  format.first = {22.0, 114.0};
  format.step = {0.01, 0.01};
  read_cell_trips(write("cells.csv", bytes), format);
}

void read_peer_scenario(std::string_view bytes) {
  read_rl4amod(write("scenario.json", bytes));
}

}  // namespace
}  // namespace evbal

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace evbal;
  static constexpr Reader readers[]{read_gps,           read_local_gps,        read_trip_table,  read_trips_by_zone,
                                    read_session_table, read_transition_table, read_count_table, read_sample_table,
                                    read_cell_table,    read_peer_scenario};
  read_any(readers, data, size);
  return 0;
}
