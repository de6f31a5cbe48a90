// What libFuzzer calls: any bytes as records of each kind. A reader takes them or throws Error; everything else is
// found.

#include "agents/world/factors.hpp"
#include "agents/world/regions_file.hpp"
#include "agents/world/stations_yaml.hpp"
#include "common/error.hpp"
#include "common/scratch_folder.hpp"
#include "tools/fit/transition_table.hpp"
#include "tools/gps/ingest_gps.hpp"
#include "tools/ingest/ingest_partition.hpp"
#include "tools/ingest/ingest_stations.hpp"
#include "tools/ingest/projection.hpp"
#include "tools/ingest/sessions.hpp"
#include "tools/ingest/travel_sample.hpp"
#include "tools/ingest/trips.hpp"
#include "tools/ingest/zone_counts.hpp"

#include <shapefil.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// A folder of this process's own, in memory where there is room.
const fs::path& folder() {
  static const ScratchFolder own(fs::exists("/dev/shm") ? "/dev/shm" : "/tmp");
  return own.path();
}

fs::path write(const std::string& name, std::string_view text) {
  fs::create_directories((folder() / name).parent_path());
  std::ofstream(folder() / name, std::ios::binary) << text;
  return folder() / name;
}

const std::vector<Region>& regions() {
  static const std::vector<Region> all{
      {"a", {{{37.7, -122.5}, {37.7, -122.4}, {37.8, -122.4}, {37.8, -122.5}}}, {37.75, -122.45}}};
  return all;
}

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

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A sound shapefile of a square and a null shape: .shp, .shx and .dbf.
std::array<std::string, 3> sound_shapefile() {
  const std::string file = (folder() / "sound.shp").string();
  SHPHandle shapes = SHPCreate(file.c_str(), SHPT_POLYGON);
  double xs[]{114.0, 114.0, 114.1, 114.1, 114.0};
  double ys[]{22.0, 22.1, 22.1, 22.0, 22.0};
  SHPObject* square = SHPCreateSimpleObject(SHPT_POLYGON, 5, xs, ys, nullptr);
  SHPObject* null = SHPCreateSimpleObject(SHPT_NULL, 0, nullptr, nullptr, nullptr);
  DBFHandle table = DBFCreate((folder() / "sound.dbf").c_str());
  DBFAddField(table, "id", FTString, 4, 0);
  DBFAddField(table, "weight", FTDouble, 8, 2);
  for (SHPObject* shape : {square, null}) {
    const int record = SHPWriteObject(shapes, -1, shape);
    SHPDestroyObject(shape);
    DBFWriteStringAttribute(table, record, 0, "a");
    DBFWriteDoubleAttribute(table, record, 1, 2.0);
  }
  SHPClose(shapes);
  DBFClose(table);
  return {text_of(folder() / "sound.shp"), text_of(folder() / "sound.shx"), text_of(folder() / "sound.dbf")};
}

/// The bytes say how the file differs from a sound one; what is left of them follows its .dbf.
void read_shapefile(std::string_view bytes) {
  static const std::array<std::string, 3> sound = sound_shapefile();
  const std::array<const char*, 3> names{"zones.shp", "zones.shx", "zones.dbf"};
  for (std::size_t part = 0; part < names.size(); ++part) {
    std::string text = sound[part];
    const std::size_t differing = std::min(bytes.size(), text.size());
    for (std::size_t i = 0; i < differing; ++i) {
      text[i] = static_cast<char>(text[i] ^ bytes[i]);
    }
    bytes.remove_prefix(differing);
    write(names[part], text + (part == 2 ? std::string(bytes) : std::string()));
  }
  read_zones(folder() / "zones.shp", {"id", "weight"});
}

void read_geojson(std::string_view bytes) {
  const auto file = read_bordering_zones(write("zones.geojson", bytes), {"id", "weight"});
  partition_zones(file, (static_cast<int>(file.zones.size()) + 1) / 2);
}

void read_stations_table(std::string_view bytes) {
  YamlMap map(YamlValue::parse("columns: {name: id, lat: lat, lon: lon, points: [n, m]}", "format.yaml"));
  const auto made = ingest_stations(write("stations.csv", bytes), read_station_format(map), regions(), 500.0);
  read_stations(write("stations.yaml", stations_yaml(made.stations, regions())), regions());
}

void read_charge_map(std::string_view bytes) {
  StationFormat format;
  format.open_charge_map = true;
  ingest_stations(write("poi.json", bytes), format, regions(), 500.0);
}

void read_transition_table(std::string_view bytes) {
  read_transitions(write("transitions.csv", bytes), regions());
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

void read_projection(std::string_view bytes) {
  const Projection projection{std::string(bytes)};
  projection.place(9.7, 52.3);
  projection.place(980'000.0, 190'000.0);
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

void read_pack_files(std::string_view bytes) {
  read_regions(write("pack.geojson", bytes));
}

}  // namespace
}  // namespace evbal

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace evbal;
  static constexpr void (*readers[])(std::string_view){
      read_gps,        read_local_gps,     read_shapefile,    read_geojson,       read_stations_table,
      read_trip_table, read_session_table, read_pack_files,   read_trips_by_zone, read_transition_table,
      read_projection, read_count_table,   read_sample_table, read_charge_map};
  if (size == 0) {
    return 0;
  }
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    readers[data[0] % std::size(readers)](bytes);
  } catch (const Error&) {
  }
  return 0;
}
