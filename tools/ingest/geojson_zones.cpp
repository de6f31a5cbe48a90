#include "common/decimal.hpp"
#include "common/error.hpp"
#include "tools/ingest/projection.hpp"
#include "tools/ingest/raw_json.hpp"
#include "tools/ingest/read_zones.hpp"
#include "tools/ingest/zone_collector.hpp"
#include "tools/ingest/zone_ids.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <string_view>

namespace evbal {
namespace {

using nlohmann::json;

/// A complaint about one feature.
using Complaint = std::domain_error;

/// Reads the features of a FeatureCollection.
class FeatureReader {
 public:
  FeatureReader(const std::filesystem::path& file, const ZoneFields& fields)
      : file_(file), fields_(fields), zones_(file, "feature") {}

  ZoneFile read(const json& collection) {
    try {
      collection_crs_ = projection_of(collection, nullptr);
    } catch (const Complaint& complaint) {
      throw bad_input(file_.string(), 0, complaint.what());
    }
    std::size_t position = 0;
    try {
      for (const auto& feature : collection.at("features")) {
        read_feature(feature, position);
        ++position;
      }
      return zones_.finish();
    } catch (const Complaint& complaint) {
      throw with_report(zones_.error(position, complaint.what()), zones_.dropped().report());
    } catch (const json::exception& error) {
      throw with_report(zones_.error(position, "is no feature with a polygon: " + words_of(error)),
                        zones_.dropped().report());
    } catch (const Error& error) {
      throw with_report(error, zones_.dropped().report());
    }
  }

 private:
  /// What the member `crs` of an object names; `otherwise` if it has none.
  const Projection* projection_of(const json& object, const Projection* otherwise) {
    const json& crs = member(object, "crs");
    if (crs.is_null()) {
      return otherwise;
    }
    const json& name = crs.is_object() ? member(member(crs, "properties"), "name") : crs;
    if (!name.is_string()) {
      throw Complaint("its `crs` names no coordinate reference system such as EPSG:2263");
    }
    const auto& text = name.get_ref<const std::string&>();
    const auto known = projections_.find(text);
    if (known != projections_.end()) {
      return &known->second;
    }
    try {
      return &projections_.emplace(text, Projection(text)).first->second;
    } catch (const Error& error) {
      throw Complaint(std::string("its `crs` ") + error.what());
    }
  }

  void read_feature(const json& feature, std::size_t position) {
    if (!feature.is_object()) {
      throw Complaint("is no GeoJSON Feature");
    }
    const json& geometry = member(feature, "geometry");
    if (geometry.is_null()) {
      zones_.drop(position, "no geometry");
      return;
    }
    crs_ = projection_of(geometry, projection_of(feature, collection_crs_));
    Zone zone;
    corners_ = false;
    const bool polygonal = add_geometry(geometry, zone, position);
    if (!zone.rings.empty()) {
      zones_.add(position, std::move(zone), name_of(feature), weight_of(feature));
    } else if (polygonal) {
      zones_.drop(position, corners_ ? "a polygon smaller than 0.1 m" : "a polygon without coordinates");
    }
  }

  /// False, and a word, if the geometry is no polygon.
  bool add_geometry(const json& geometry, Zone& zone, std::size_t position) {
    const auto& type = geometry.at("type").get_ref<const std::string&>();
    if (type == "Polygon") {
      add_polygon(geometry.at("coordinates"), zone);
    } else if (type == "MultiPolygon") {
      for (const auto& polygon : geometry.at("coordinates")) {
        add_polygon(polygon, zone);
      }
    } else if (type == "GeometryCollection") {
      const json& parts = geometry.at("geometries");
      if (parts.empty()) {
        zones_.drop(position, "no geometry");
      }
      bool polygonal = false;
      for (const auto& part : parts) {
        polygonal = add_geometry(part, zone, position) || polygonal;
      }
      return polygonal;
    } else {
      zones_.drop(position, "geometry " + shown(type) + ", which is no polygon");
      return false;
    }
    return true;
  }

  void add_polygon(const json& rings, Zone& zone) {
    for (std::size_t r = 0; r < rings.size(); ++r) {
      add_ring(zone, read_ring(rings[r]), r > 0);
    }
  }

  std::vector<LatLon> read_ring(const json& positions) {
    std::vector<LatLon> ring;
    for (const auto& position : positions) {
      ring.push_back(place(position.at(0).get<double>(), position.at(1).get<double>()));
      corners_ = true;
    }
    return ring;
  }

  LatLon place(double x, double y) const {
    if (crs_ != nullptr) {
      if (const auto turned = crs_->place(x, y)) {
        return *turned;
      }
      throw Complaint("position " + decimal(x) + ", " + decimal(y) + " lies where " + shown(crs_->name()) +
                      " is not used; is that its `crs`, and are these its units?");
    }
    if (std::abs(y) > 90.0 || std::abs(x) > 180.0) {
      throw Complaint("position " + decimal(x) + ", " + decimal(y) +
                      " is not in degrees (WGS84); a member `crs` must name another system");
    }
    return {y, x};
  }

  std::string name_of(const json& feature) const {
    return fields_.name.empty() ? "" : zone_id(field(feature, fields_.name));
  }

  static std::string zone_id(const json& value) {
    if (value.is_string()) {
      return trimmed_id(value.get_ref<const std::string&>());
    }
    if (!value.is_number()) {
      throw Complaint("its name " + value.dump() + " is neither text nor a number");
    }
    const std::string digits = value.is_number_float() ? decimal(value.get<double>()) : value.dump();
    return whole_number(digits).value_or(digits);
  }

  std::optional<double> weight_of(const json& feature) const {
    if (fields_.weight.empty()) {
      return std::nullopt;
    }
    const json& value = field(feature, fields_.weight);
    const auto number = number_in(value);
    if (!number || *number < 0.0) {
      throw Complaint("weight " + value.dump() + " is no number from 0 on");
    }
    return number;
  }

  /// A property that the feature must have; `id` may be its own.
  static const json& field(const json& feature, const std::string& name) {
    const json& property = member(member(feature, "properties"), name);
    const json& value = property.is_null() && name == "id" ? member(feature, "id") : property;
    if (value.is_null() || (value.is_string() && trimmed_id(value.get_ref<const std::string&>()).empty())) {
      throw Complaint("has no property `" + name + "`");
    }
    return value;
  }

  const std::filesystem::path& file_;
  const ZoneFields& fields_;
  ZoneCollector zones_;
  std::map<std::string, Projection> projections_;  ///< by the name of the system
  const Projection* collection_crs_ = nullptr;     ///< null: degrees
  const Projection* crs_ = nullptr;                ///< of the feature that is read
  bool corners_ = false;                           ///< whether that has any
};

}  // namespace

ZoneFile read_geojson_zones(const std::filesystem::path& file, const ZoneFields& fields) {
  const json collection = read_raw_json(file, "GeoJSON", "FeatureCollection");
  if (!member(collection, "features").is_array()) {
    const json& type = member(collection, "type");
    const bool other = type.is_string() && type != "FeatureCollection";
    throw bad_input(file.string(), 0,
                    "is no GeoJSON FeatureCollection, " +
                        (other ? "but a " + shown(type.get<std::string>()) : "with a list of `features`"));
  }
  return FeatureReader(file, fields).read(collection);
}

}  // namespace evbal
