#pragma once

#include "agents/world/geometry.hpp"
#include "tools/records/raw_table.hpp"

#include <string>

namespace evbal {

/// Puts the place in two columns of a row, degrees of latitude and longitude, into `place`; or says under which of the
/// two reasons it cannot.
RowFault read_place(const RawTable& row, std::size_t lat_column, std::size_t lon_column, LatLon& place,
                    std::string_view no_lat = "no latitude in degrees, -90 to 90",
                    std::string_view no_lon = "no longitude in degrees, -180 to 180");

/// Latitude and longitude as a message shows them, to about a metre.
std::string place_text(LatLon place);

}  // namespace evbal
