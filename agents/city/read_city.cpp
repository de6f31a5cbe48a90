#include "agents/city/city.hpp"
#include "agents/city/pack_keys.hpp"
#include "agents/city/table.hpp"
#include "common/yaml.hpp"

#include <algorithm>
#include <set>

namespace evbal {
namespace {

constexpr int kMaxRegions = 5000;
constexpr double kMaxMinutes = 24.0 * 60.0;
constexpr double kMaxKm = 1000.0;

ChargingAssumption read_charging(const YamlValue& value) {
  YamlMap map(value);
  ChargingAssumption charging;
  charging.power_kw = map.require("power_kw").number(0.1, 10'000.0);
  const YamlValue quantiles = map.require("session_quantiles");
  for (const auto& item : quantiles.items()) {
    charging.session_quantiles.push_back(item.duration());
    if (charging.session_quantiles.back() < 1.0 || charging.session_quantiles.back() > kMaxMinutes) {
      throw item.error("`" + item.text() + "` is no session length; give 1min to 24h");
    }
  }
  if (charging.session_quantiles.size() < 2 ||
      !std::is_sorted(charging.session_quantiles.begin(), charging.session_quantiles.end())) {
    throw quantiles.error("expected at least two durations, ascending");
  }
  map.finish();
  return charging;
}

/// Longitude, latitude: the order of GeoJSON.
LatLon read_position(const YamlValue& value) {
  const auto items = value.items();
  if (items.size() != 2) {
    throw value.error("expected a position, [longitude, latitude]");
  }
  return {items[1].number(-90.0, 90.0), items[0].number(-180.0, 180.0)};
}

std::vector<LatLon> read_ring(const YamlValue& value) {
  std::vector<LatLon> ring;
  for (const auto& position : value.items()) {
    ring.push_back(read_position(position));
  }
  if (ring.size() < 4 || ring.front().lat != ring.back().lat || ring.front().lon != ring.back().lon) {
    throw value.error("a ring has at least four positions, the last equal to the first");
  }
  ring.pop_back();
  return ring;
}

void expect_type(YamlMap& map, const std::string& type) {
  map.require("type").one_of({type});
}

Region read_region(const YamlValue& feature) {
  YamlMap map(feature);
  expect_type(map, "Feature");
  YamlMap properties(map.require("properties"));
  Region region;
  region.name = properties.require("name").text();
  region.centroid = read_position(properties.require("centroid"));
  properties.finish();
  YamlMap geometry(map.require("geometry"));
  expect_type(geometry, "MultiPolygon");
  for (const auto& polygon : geometry.require("coordinates").items()) {
    const auto rings = polygon.items();
    if (rings.size() != 1) {
      throw polygon.error("expected one ring; regions have no holes");
    }
    region.outline.push_back(read_ring(rings.front()));
  }
  if (region.outline.empty()) {
    throw feature.error("a region needs an outline");
  }
  geometry.finish();
  map.finish();
  return region;
}

std::vector<Region> read_regions(const std::filesystem::path& file) {
  YamlMap map(YamlValue::load(file));
  expect_type(map, "FeatureCollection");
  std::vector<Region> regions;
  std::set<std::string> names;
  for (const auto& feature : map.require("features").items()) {
    regions.push_back(read_region(feature));
    if (regions.back().name.empty() || !names.insert(regions.back().name).second) {
      throw feature.error("region name `" + regions.back().name + "` is empty or given twice");
    }
  }
  map.finish();
  return regions;
}

Station read_station(const YamlValue& value, const std::vector<std::string>& region_names) {
  YamlMap map(value);
  Station station;
  station.name = map.require("name").text();
  station.region = static_cast<int>(map.require("region").one_of(region_names));
  station.points = map.require("points").integer(1, 10'000);
  station.place = {map.require("lat").number(-90.0, 90.0), map.require("lon").number(-180.0, 180.0)};
  map.finish();
  return station;
}

std::vector<Station> read_stations(const YamlValue& value, const std::vector<Region>& regions) {
  std::vector<std::string> region_names;
  region_names.reserve(regions.size());
  for (const auto& region : regions) {
    region_names.push_back(region.name);
  }
  std::vector<Station> stations;
  std::set<std::string> names;
  for (const auto& item : value.items()) {
    stations.push_back(read_station(item, region_names));
    if (!names.insert(stations.back().name).second) {
      throw item.error("station name `" + stations.back().name + "` is given twice");
    }
  }
  return stations;
}

void read_travel(const std::filesystem::path& file, City& city) {
  const int n = city.size();
  city.km = Eigen::MatrixXd::Zero(n, n);
  city.minutes = Eigen::MatrixXd::Zero(n, n);
  PackTable table(file, "from,to,km,minutes");
  for (int from = 0; from < n; ++from) {
    for (int to = 0; to < n; ++to) {
      const std::string pair = std::to_string(from) + "," + std::to_string(to);
      if (!table.next()) {
        throw table.error("ends before pair " + pair + "; every pair needs a line");
      }
      if (table.integer(0, 0, n - 1) != from || table.integer(1, 0, n - 1) != to) {
        throw table.error("expected pair " + pair + "; pairs are sorted and complete");
      }
      city.km(from, to) = table.number(2, 0.001, kMaxKm);
      city.minutes(from, to) = table.number(3, 1.0, kMaxMinutes);
    }
  }
  if (table.next()) {
    throw table.error("more lines than pairs of " + std::to_string(n) + " regions");
  }
}

}  // namespace

City read_city(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) {
    throw bad_input(folder.string(), 0, "is no city pack; give a folder with a city.yaml");
  }
  YamlMap map(YamlValue::load(folder / "city.yaml"));
  map.require("format").one_of({"evbal-city-1"});
  City city;
  city.folder = folder;
  city.name = map.require("name").text();
  city.source = map.require("source").text();
  read_clock(map, city);
  const YamlValue count = map.require("regions");
  city.regions = read_regions(folder / "regions.geojson");
  if (count.integer(1, kMaxRegions) != city.size()) {
    throw count.error("regions.geojson has " + std::to_string(city.size()) + " regions");
  }
  read_days(map.require("days"), city);
  city.fleet = read_fleet(map.require("fleet"));
  city.charging = read_charging(map.require("charging"));
  city.passengers = read_passengers(map.require("passengers"));
  city.stations = read_stations(map.require("stations"), city.regions);
  map.finish();
  read_travel(folder / "travel.csv", city);
  return city;
}

}  // namespace evbal
