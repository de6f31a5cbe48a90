#include "agents/world/stations_yaml.hpp"

namespace evbal {

void write_stations(YamlWriter& yaml, const std::vector<Station>& stations, const std::vector<Region>& regions) {
  yaml.key("stations").begin_list();
  for (const auto& station : stations) {
    yaml.begin_map(YamlWriter::Layout::one_line).key("name").text(station.name);
    yaml.key("region").text(regions[station.region].name).key("points").number(station.points);
    yaml.key("lat").number(station.place.lat).key("lon").number(station.place.lon).end_map();
  }
  yaml.end_list();
}

std::string stations_yaml(const std::vector<Station>& stations, const std::vector<Region>& regions) {
  YamlWriter yaml;
  write_stations(yaml, stations, regions);
  return yaml.finish();
}

}  // namespace evbal
