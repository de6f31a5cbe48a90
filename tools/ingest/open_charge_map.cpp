#include "tools/ingest/open_charge_map.hpp"

#include "tools/ingest/point_sum.hpp"
#include "tools/ingest/raw_json.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace evbal {

using nlohmann::json;

RowFault ChargeMapEntry::fault(std::string_view reason, const json& value) {
  value_ = value.dump();
  return {reason, value_};
}

RowFault ChargeMapEntry::read(const json& entry, Station& station) {
  untold_ = 0;
  const json& address = member(entry, "AddressInfo");
  if (!address.is_object()) {
    return fault("no AddressInfo", address);
  }
  const json& title = member(address, "Title");
  name_ = title.is_string() ? title.get_ref<const std::string&>() : std::string();
  station.name = name_;
  const RowFault wrong = read_place(address, station.place);
  return wrong ? wrong : read_points(entry, station.points);
}

RowFault ChargeMapEntry::read_place(const json& address, LatLon& place) {
  const json& lat = member(address, "Latitude");
  const json& lon = member(address, "Longitude");
  place = {number_in(lat).value_or(360.0), number_in(lon).value_or(360.0)};
  if (std::abs(place.lat) > 90.0) {
    return fault("no latitude in degrees, -90 to 90", lat);
  }
  return std::abs(place.lon) > 180.0 ? fault("no longitude in degrees, -180 to 180", lon) : RowFault();
}

RowFault ChargeMapEntry::read_points(const json& entry, int& points) {
  PointSum sum;
  const json& whole = member(entry, "NumberOfPoints");
  if (!whole.is_null() && number_in(whole) != 0.0) {
    const RowFault wrong = sum.add(number_in(whole), value_ = whole.dump());
    return wrong ? wrong : sum.total(name_, points);
  }
  int told = 0;
  for (const json& connection : member(entry, "Connections")) {
    const json& quantity = member(connection, "Quantity");
    if (quantity.is_null()) {
      ++untold_;
      continue;
    }
    if (const RowFault wrong = sum.add(number_in(quantity), value_ = quantity.dump())) {
      return wrong;
    }
    ++told;
  }
  untold_ = told > 0 ? untold_ : 0;
  return sum.total(name_, points);
}

}  // namespace evbal
