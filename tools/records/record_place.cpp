#include "tools/records/record_place.hpp"

#include "common/decimal.hpp"

#include <cmath>

namespace evbal {

RowFault read_place(const RawTable& row, std::size_t lat_column, std::size_t lon_column, LatLon& place,
                    std::string_view no_lat, std::string_view no_lon) {
  const auto lat = row.number(lat_column);
  if (!lat || std::abs(*lat) > 90.0) {
    return {no_lat, row.text(lat_column)};
  }
  const auto lon = row.number(lon_column);
  if (!lon || std::abs(*lon) > 180.0) {
    return {no_lon, row.text(lon_column)};
  }
  place = {*lat, *lon};
  return {};
}

std::string place_text(LatLon place) {
  constexpr double kParts = 1e5;
  return decimal(std::round(place.lat * kParts) / kParts) + ", " + decimal(std::round(place.lon * kParts) / kParts);
}

}  // namespace evbal
