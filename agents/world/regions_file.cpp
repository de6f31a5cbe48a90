#include "agents/world/regions_file.hpp"

#include "agents/world/pack_keys.hpp"
#include "common/yaml.hpp"

#include <nlohmann/json.hpp>

#include <set>

namespace evbal {
namespace {

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

using Json = nlohmann::ordered_json;

Json position_json(LatLon point) {
  return {point.lon, point.lat};
}

/// One polygon of a MultiPolygon: its only ring, closed.
Json polygon_json(const std::vector<LatLon>& ring) {
  Json positions = Json::array();
  for (const LatLon point : ring) {
    positions.push_back(position_json(point));
  }
  positions.push_back(position_json(ring.front()));
  return Json::array({positions});
}

Json feature_json(const Region& region) {
  Json polygons = Json::array();
  for (const auto& ring : region.outline) {
    polygons.push_back(polygon_json(ring));
  }
  return {{"type", "Feature"},
          {"properties", {{"name", region.name}, {"centroid", position_json(region.centroid)}}},
          {"geometry", {{"type", "MultiPolygon"}, {"coordinates", polygons}}}};
}

}  // namespace

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

std::string regions_geojson(const std::vector<Region>& regions) {
  std::string text = R"({"type":"FeatureCollection","features":[)";
  for (const auto& region : regions) {
    text += (&region == &regions.front() ? "\n" : ",\n") + feature_json(region).dump();
  }
  return text + "\n]}\n";
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

std::vector<Station> read_stations(const std::filesystem::path& file, const std::vector<Region>& regions) {
  return read_stations(YamlMap(YamlValue::load(file)).require("stations"), regions);
}

}  // namespace evbal
