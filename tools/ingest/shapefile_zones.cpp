#include "agents/world/pack_table.hpp"
#include "common/decimal.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/plain_text.hpp"
#include "tools/ingest/projection.hpp"
#include "tools/ingest/read_zones.hpp"
#include "tools/ingest/zone_collector.hpp"
#include "tools/ingest/zone_ids.hpp"

#include <shapefil.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <memory>

namespace evbal {
namespace {

namespace fs = std::filesystem;

bool same_but_for_case(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// The file itself if it exists, else the first by name whose ending differs from it in case only, else the file.
fs::path in_any_case(const fs::path& file) {
  if (fs::exists(file)) {
    return file;
  }
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code none;
  fs::path found;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const fs::path& other = entry.path();
    if (other.stem() == file.stem() && same_but_for_case(other.extension().string(), file.extension().string()) &&
        (found.empty() || other < found)) {
      found = other;
    }
  }
  return found.empty() ? file : found;
}

/// Shapelib's own hooks print what they find wrong; what matters shows in what its functions return.
SAHooks hooks_of_ours() {
  SAHooks hooks{};
  SASetupDefaultHooks(&hooks);
  hooks.Error = [](const char*) {};
  // Newer versions hand over one thing more.
  hooks.FOpen = [](const char* name, const char* access, auto...) {
    return reinterpret_cast<SAFile>(std::fopen(in_any_case(name).c_str(), access));
  };
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

/// The file with another suffix, in any case.
fs::path beside(const fs::path& file, const std::string& suffix) {
  return in_any_case(fs::path(file).replace_extension(suffix));
}

/// The system that the .prj names; nothing if there is none: then positions are degrees.
std::optional<Projection> projection_of(const fs::path& file) {
  const fs::path prj = beside(file, ".prj");
  std::string definition = text_of_file(prj);
  if (definition.starts_with("\xEF\xBB\xBF")) {
    definition.erase(0, 3);  // the byte order mark
  }
  if (trimmed_id(definition).empty()) {
    return std::nullopt;
  }
  try {
    return Projection(definition);
  } catch (const Error& error) {
    throw bad_input(prj.string(), 1, error.what());
  }
}

/// The shapes of a file as zones without name and weight.
class Shapes {
 public:
  explicit Shapes(const fs::path& file) : file_(file), projection_(projection_of(file)) {
    SAHooks hooks = hooks_of_ours();
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

  /// Nothing if the shape is null or without corners.
  std::optional<Zone> zone(int record) const {
    const std::unique_ptr<SHPObject, DestroyShape> shape(SHPReadObject(shapes_.get(), record));
    if (!shape) {
      throw bad_input(file_.string(), 0, "shape " + std::to_string(record) + " cannot be read; is the file truncated?");
    }
    if (shape->nSHPType == SHPT_NULL || shape->nVertices == 0) {
      return std::nullopt;
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
    return zone;
  }

 private:
  LatLon place(double x, double y, int record) const {
    if (projection_) {
      if (const auto turned = projection_->place(x, y)) {
        return *turned;
      }
      throw bad_input(file_.string(), 0,
                      "shape " + std::to_string(record) + ": position " + decimal(x) + ", " + decimal(y) +
                          " lies where " + shown(projection_->name()) + " is not used; is its .prj complete?");
    }
    if (!(std::abs(y) <= 90.0 && std::abs(x) <= 180.0)) {
      throw bad_input(file_.string(), 0,
                      "shape " + std::to_string(record) + ": position " + decimal(x) + ", " + decimal(y) +
                          " is not in degrees; a .prj beside the file must say what it is in");
    }
    return {y, x};
  }

  static bool clockwise(const std::vector<LatLon>& ring) {
    const LatLon from = ring.front();
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const LatLon& a = ring[i];
      const LatLon& b = ring[(i + 1) % ring.size()];
      const double a_east = longitude_near(a.lon, from.lon) - from.lon;
      const double b_east = longitude_near(b.lon, from.lon) - from.lon;
      twice += a_east * (b.lat - from.lat) - b_east * (a.lat - from.lat);
    }
    return twice < 0.0;
  }

  fs::path file_;
  std::optional<Projection> projection_;
  std::unique_ptr<SHPInfo, CloseShapes> shapes_;
  int count_ = 0;
};

/// The fields of the shapes.
class Fields {
 public:
  Fields(const fs::path& file, int shapes) : file_(beside(file, ".dbf")) {
    SAHooks hooks = hooks_of_ours();
    table_.reset(DBFOpenLL(file_.c_str(), "rb", &hooks));
    if (!table_ || DBFGetRecordCount(table_.get()) != shapes) {
      throw bad_input(file_.string(), 0,
                      "cannot be read, or has not a record for each of " + std::to_string(shapes) + " shapes");
    }
  }

  std::string text(int record, const std::string& field) const {
    const int at = column(field);
    if (DBFIsAttributeNULL(table_.get(), record, at) != 0) {
      throw bad_input(file_.string(), 0, "record " + std::to_string(record) + ": has no `" + field + "`");
    }
    const DBFFieldType type = DBFGetFieldInfo(table_.get(), at, nullptr, nullptr, nullptr);
    const double number = DBFReadDoubleAttribute(table_.get(), record, at);
    const bool numeric = (type == FTInteger || type == FTDouble) && std::isfinite(number);
    const std::string shown = numeric ? decimal(number) : DBFReadStringAttribute(table_.get(), record, at);
    if (const auto complaint = validate_line(shown); !complaint.empty()) {
      throw bad_input(file_.string(), 0, "record " + std::to_string(record) + ": field `" + field + "` " + complaint);
    }
    return trimmed_id(shown);
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

bool is_shapefile(const fs::path& file) {
  return same_but_for_case(file.extension().string(), ".shp");
}

ZoneFile read_shapefile_zones(const fs::path& file, const ZoneFields& fields) {
  ZoneCollector zones(file, "shape");
  try {
    const Shapes shapes(file);
    std::unique_ptr<const Fields> table;
    if (!fields.name.empty() || !fields.weight.empty()) {
      table = std::make_unique<const Fields>(file, shapes.count());
    }
    for (int record = 0; record < shapes.count(); ++record) {
      auto zone = shapes.zone(record);
      if (!zone || zone->rings.empty()) {
        zones.drop(record, zone ? "a polygon smaller than 0.1 m" : "a null shape or one without corners");
        continue;
      }
      zones.add(record, std::move(*zone), fields.name.empty() ? "" : table->text(record, fields.name),
                fields.weight.empty() ? std::nullopt : std::optional(table->weight(record, fields.weight)));
    }
    return zones.finish();
  } catch (const Error& error) {
    throw with_report(error, zones.dropped().report());
  }
}

}  // namespace evbal
