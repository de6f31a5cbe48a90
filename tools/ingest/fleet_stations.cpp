#include "tools/ingest/fleet_stations.hpp"

#include "tools/ingest/station_list.hpp"

namespace evbal {

FleetStations read_fleet_stations(YamlMap& map, City& city) {
  FleetStations stations;
  stations.format = read_station_format(map);
  stations.share = map.require("share").number(0.0, 1.0);
  city.charging.power_kw = map.require("power_kw").number(0.1, 10'000.0);
  return stations;
}

std::string add_stations(const std::filesystem::path& list, const FleetStations& stations, double snap_m, City& city) {
  const IngestedStations made = ingest_stations(list, stations.format, city.regions, snap_m);
  city.stations = share_of_points(made.stations, stations.share);
  return made.report + "points for the fleet: " + std::to_string(city.points().sum()) + " at " +
         std::to_string(city.stations.size()) + " stations\n";
}

}  // namespace evbal
