// What libFuzzer calls: any bytes as polygons of each kind, and as the projection that they are drawn in.

#include "agents/world/regions_file.hpp"
#include "tests/fuzz/any_bytes.hpp"
#include "tools/ingest/ingest_partition.hpp"
#include "tools/ingest/projection.hpp"

#include <shapefil.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace evbal {
namespace {

std::string text_of(const std::filesystem::path& file) {
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

void read_pack_files(std::string_view bytes) {
  read_regions(write("pack.geojson", bytes));
}

void read_projection(std::string_view bytes) {
  const Projection projection{std::string(bytes)};
  projection.place(9.7, 52.3);
  projection.place(980'000.0, 190'000.0);
}

}  // namespace
}  // namespace evbal

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace evbal;
  static constexpr Reader readers[]{read_shapefile, read_geojson, read_pack_files, read_projection};
  read_any(readers, data, size);
  return 0;
}
