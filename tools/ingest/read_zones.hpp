#pragma once

#include "tools/ingest/zones.hpp"

namespace evbal {

/// read_zones for GeoJSON. Positions are WGS84 degrees unless a member `crs` names another system.
ZoneFile read_geojson_zones(const std::filesystem::path& file, const ZoneFields& fields);

/// Whether a file's name ends in .shp, in any case.
bool is_shapefile(const std::filesystem::path& file);

/// read_zones for shapefiles. Positions are WGS84 degrees unless a .prj beside the file names another system; fields
/// are those of the .dbf. The endings may be in any case.
ZoneFile read_shapefile_zones(const std::filesystem::path& file, const ZoneFields& fields);

}  // namespace evbal
