// What libFuzzer calls: any bytes as lists of charging stations of each kind.

#include "agents/world/regions_file.hpp"
#include "agents/world/stations_yaml.hpp"
#include "tests/fuzz/any_bytes.hpp"
#include "tools/ingest/ingest_stations.hpp"

namespace evbal {
namespace {

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

void read_pack_stations(std::string_view bytes) {
  read_stations(write("any.yaml", bytes), regions());
}

}  // namespace
}  // namespace evbal

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace evbal;
  static constexpr Reader readers[]{read_stations_table, read_charge_map, read_pack_stations};
  read_any(readers, data, size);
  return 0;
}
