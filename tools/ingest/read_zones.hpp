#pragma once

#include "tools/ingest/zones.hpp"

namespace evbal {

/// read_zones for GeoJSON.
std::vector<Zone> read_geojson_zones(const std::filesystem::path& file, const ZoneFields& fields);

/// read_zones for shapefiles. Positions are degrees, or Web Mercator metres if the .prj beside the file says so; fields
/// are those of the .dbf.
std::vector<Zone> read_shapefile_zones(const std::filesystem::path& file, const ZoneFields& fields);

}  // namespace evbal
