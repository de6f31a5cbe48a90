#include "agents/world/pack_table.hpp"
#include "common/decimal.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/plain_text.hpp"
#include "tools/ingest/read_zones.hpp"

#include <shapefil.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace evbal {
namespace {

namespace fs = std::filesystem;

constexpr double kMercatorRadius = 6378137.0;  // m

/// Shapelib's own hooks print what they find wrong; what matters shows in what its functions return.
SAHooks silent_hooks() {
  SAHooks hooks{};
  SASetupDefaultHooks(&hooks);
  hooks.Error = [](const char*) {};
  return hooks;
}

struct CloseShapes {
  void operator()(SHPInfo* shapes) const { SHPClose(shapes); }
};
struct CloseTable {
  void operator()(DBFInfo* table) const { DBFClose(table); }
};
struct DestroyShape {
  void operator()(SHPObject* shape) const { SHPDestroyObject(shape); }
};

/// The file with another suffix.
fs::path beside(const fs::path& file, const std::string& suffix) {
  return fs::path(file).replace_extension(suffix);
}

/// True if positions are Web Mercator metres, false if degrees. Throws on any other projection.
bool in_web_mercator(const fs::path& file) {
  const std::string projection = text_of_file(beside(file, ".prj"));
  if (projection.empty() || projection.starts_with("GEOGCS")) {
    return false;
  }
  if (projection.find("Mercator_Auxiliary_Sphere") == std::string::npos &&
      projection.find("Pseudo-Mercator") == std::string::npos) {
    throw bad_input(beside(file, ".prj").string(), 1, "is another projection than WGS84 degrees or Web Mercator");
  }
  return true;
}

LatLon from_web_mercator(double x, double y) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  return {(2.0 * std::atan(std::exp(y / kMercatorRadius)) - std::numbers::pi / 2.0) / kDegree,
          x / kMercatorRadius / kDegree};
}

/// The shapes of a file as zones without name and weight.
class Shapes {
 public:
  explicit Shapes(const fs::path& file) : file_(file), mercator_(in_web_mercator(file)) {
    SAHooks hooks = silent_hooks();
    shapes_.reset(SHPOpenLL(file.c_str(), "rb", &hooks));
    if (!shapes_) {
      throw bad_input(file.string(), 0, "cannot be read as a shapefile; its .shx must lie beside it");
    }
    int type = 0;
    SHPGetInfo(shapes_.get(), &count_, &type, nullptr, nullptr);
    if (type != SHPT_POLYGON && type != SHPT_POLYGONZ && type != SHPT_POLYGONM) {
      throw bad_input(file.string(), 0, "holds no polygons");
    }
  }

  int count() const { return count_; }

  Zone zone(int record) const {
    const std::unique_ptr<SHPObject, DestroyShape> shape(SHPReadObject(shapes_.get(), record));
    if (!shape) {
      throw bad_input(file_.string(), 0, "shape " + std::to_string(record) + " cannot be read; is the file truncated?");
    }
    SHPRewindObject(shapes_.get(), shape.get());
    Zone zone;
    for (int part = 0; part < shape->nParts; ++part) {
      const int end = part + 1 < shape->nParts ? shape->panPartStart[part + 1] : shape->nVertices;
      std::vector<LatLon> ring;
      for (int v = shape->panPartStart[part]; v < end; ++v) {
        ring.push_back(place(shape->padfX[v], shape->padfY[v], record));
      }
      add_ring(zone, ring, !clockwise(ring));  // in shapefiles outer rings run clockwise
    }
    if (!zone.rings.empty()) {
      measure(zone);
    }
    return zone;
  }

 private:
  LatLon place(double x, double y, int record) const {
    const LatLon point = mercator_ ? from_web_mercator(x, y) : LatLon{y, x};
    if (!(std::abs(point.lat) <= 90.0 && std::abs(point.lon) <= 180.0)) {
      throw bad_input(
          file_.string(), 0,
          "shape " + std::to_string(record) + " is not in degrees; a .prj must say so if it is Web Mercator");
    }
    return point;
  }

  static bool clockwise(const std::vector<LatLon>& ring) {
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const LatLon& a = ring[i];
      const LatLon& b = ring[(i + 1) % ring.size()];
      twice += (a.lon - ring[0].lon) * (b.lat - ring[0].lat) - (b.lon - ring[0].lon) * (a.lat - ring[0].lat);
    }
    return twice < 0.0;
  }

  fs::path file_;
  bool mercator_;
  std::unique_ptr<SHPInfo, CloseShapes> shapes_;
  int count_ = 0;
};

/// The fields of the shapes.
class Fields {
 public:
  Fields(const fs::path& file, int shapes) : file_(beside(file, ".dbf")) {
    SAHooks hooks = silent_hooks();
    table_.reset(DBFOpenLL(file_.c_str(), "rb", &hooks));
    if (!table_ || DBFGetRecordCount(table_.get()) != shapes) {
      throw bad_input(file_.string(), 0,
                      "cannot be read, or has not a record for each of " + std::to_string(shapes) + " shapes");
    }
  }

  std::string text(int record, const std::string& field) const {
    const int at = column(field);
    const DBFFieldType type = DBFGetFieldInfo(table_.get(), at, nullptr, nullptr, nullptr);
    const double number = DBFReadDoubleAttribute(table_.get(), record, at);
    const bool numeric = (type == FTInteger || type == FTDouble) && std::isfinite(number);
    std::string shown = numeric ? decimal(number) : DBFReadStringAttribute(table_.get(), record, at);
    if (const auto complaint = line_complaint(shown); !complaint.empty()) {
      throw bad_input(file_.string(), 0, "record " + std::to_string(record) + ": field `" + field + "` " + complaint);
    }
    return shown;
  }

  double weight(int record, const std::string& field) const {
    const std::string shown = text(record, field);
    const auto value = parse_number(shown);
    if (!value || *value < 0.0) {
      throw bad_input(file_.string(), 0,
                      "record " + std::to_string(record) + ": weight `" + shown + "` is no number from 0 on");
    }
    return *value;
  }

 private:
  int column(const std::string& field) const {
    const int at = DBFGetFieldIndex(table_.get(), field.c_str());
    if (at < 0) {
      throw bad_input(file_.string(), 0, "has no field `" + field + "`");
    }
    return at;
  }

  fs::path file_;
  std::unique_ptr<DBFInfo, CloseTable> table_;
};

}  // namespace

std::vector<Zone> read_shapefile_zones(const fs::path& file, const ZoneFields& fields) {
  const Shapes shapes(file);
  std::unique_ptr<const Fields> table;
  if (!fields.name.empty() || !fields.weight.empty()) {
    table = std::make_unique<const Fields>(file, shapes.count());
  }
  std::vector<Zone> zones;
  for (int record = 0; record < shapes.count(); ++record) {
    Zone zone = shapes.zone(record);
    if (zone.rings.empty()) {
      continue;
    }
    zone.name = fields.name.empty() ? std::to_string(record) : table->text(record, fields.name);
    zone.weight = fields.weight.empty() ? zone.area_m2 : table->weight(record, fields.weight);
    zones.push_back(std::move(zone));
  }
  return zones;
}

}  // namespace evbal
