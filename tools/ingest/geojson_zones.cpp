#include "agents/world/pack_table.hpp"
#include "common/error.hpp"
#include "tools/ingest/read_zones.hpp"
#include "tools/records/text_lines.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace evbal {
namespace {

using nlohmann::json;

std::vector<LatLon> read_ring(const json& positions) {
  std::vector<LatLon> ring;
  for (const auto& position : positions) {
    const LatLon point{position.at(1).get<double>(), position.at(0).get<double>()};
    if (std::abs(point.lat) > 90.0 || std::abs(point.lon) > 180.0) {
      throw std::domain_error("a position is not in degrees (WGS84)");
    }
    ring.push_back(point);
  }
  return ring;
}

void add_polygon(const json& rings, Zone& zone) {
  for (std::size_t r = 0; r < rings.size(); ++r) {
    add_ring(zone, read_ring(rings[r]), r > 0);
  }
}

Zone read_polygons(const json& geometry) {
  const auto& type = geometry.at("type").get_ref<const std::string&>();
  Zone zone;
  if (type == "Polygon") {
    add_polygon(geometry.at("coordinates"), zone);
  } else if (type == "MultiPolygon") {
    for (const auto& polygon : geometry.at("coordinates")) {
      add_polygon(polygon, zone);
    }
  } else {
    throw std::domain_error("geometry `" + type + "` is neither Polygon nor MultiPolygon");
  }
  return zone;
}

double read_weight(const json& value) {
  const auto number =
      value.is_string() ? parse_number(value.get_ref<const std::string&>()) : std::optional(value.get<double>());
  if (!number || *number < 0.0) {
    throw std::domain_error("weight " + value.dump() + " is no number from 0 on");
  }
  return *number;
}

void read_fields(const json& feature, const ZoneFields& fields, Zone& zone) {
  if (!fields.name.empty()) {
    const json& name = feature.at("properties").at(fields.name);
    zone.name = name.is_string() ? name.get<std::string>() : name.dump();
  }
  if (!fields.weight.empty()) {
    zone.weight = read_weight(feature.at("properties").at(fields.weight));
  }
}

}  // namespace

std::vector<Zone> read_geojson_zones(const std::filesystem::path& file, const ZoneFields& fields) {
  std::vector<Zone> zones;
  std::size_t position = 0;
  try {
    const json collection = json::parse(unpacked_text(file));
    for (const auto& feature : collection.at("features")) {
      Zone zone = read_polygons(feature.at("geometry"));
      if (!zone.rings.empty()) {
        measure(zone);
        zone.name = std::to_string(position);
        zone.weight = zone.area_m2;
        read_fields(feature, fields, zone);
        zones.push_back(std::move(zone));
      }
      ++position;
    }
  } catch (const std::domain_error& error) {
    throw bad_input(file.string(), 0, "feature " + std::to_string(position) + ": " + error.what());
  } catch (const json::exception& error) {
    throw bad_input(file.string(), 0, std::string("is no GeoJSON FeatureCollection of polygons: ") + error.what());
  }
  return zones;
}

}  // namespace evbal
