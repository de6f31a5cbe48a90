#include "tools/gps/gps_format.hpp"

namespace evbal {
namespace {

void read_vehicle(YamlMap& map, YamlMap& columns, GpsFormat& format) {
  const auto column = columns.find("vehicle");
  const auto files = map.find("vehicle_in_name");
  if (column.has_value() == files.has_value()) {
    throw map.value().error("the vehicle is told by a column `vehicle` or by `vehicle_in_name`; give one of them");
  }
  if (column) {
    format.vehicle = add_column(format.table, *column);
    return;
  }
  const std::string pattern = files->text();
  const std::size_t star = pattern.find('*');
  if (star == std::string::npos || pattern.find('*', star + 1) != std::string::npos) {
    throw files->error("expected a file's name with one * where the vehicle stands, such as \"cab_*.txt\"");
  }
  format.file_prefix = pattern.substr(0, star);
  format.file_suffix = pattern.substr(star + 1);
}

ChargingRule read_charging_rule(const YamlValue& value) {
  YamlMap map(value);
  ChargingRule rule;
  if (const auto metres = map.find("within_m")) {
    rule.within_m = metres->number(1.0, 5000.0);
  }
  if (const auto minutes = map.find("longer_than")) {
    rule.longer_than = minutes->duration();
  }
  if (const auto minutes = map.find("longest_gap")) {
    rule.longest_gap = minutes->duration();
  }
  if (const auto metres = map.find("moved_m")) {
    rule.moved_m = metres->number(0.0, 1e5);
  }
  map.finish();
  return rule;
}

}  // namespace

GpsFormat read_gps_format(const std::filesystem::path& file) {
  YamlMap map(YamlValue::load(file));
  GpsFormat format;
  format.table = read_table_format(map);
  YamlMap columns(map.require("columns"));
  read_vehicle(map, columns, format);
  format.time = add_column(format.table, columns.require("time"));
  format.lat = add_column(format.table, columns.require("lat"));
  format.lon = add_column(format.table, columns.require("lon"));
  format.occupied = add_column(format.table, columns.require("occupied"));
  columns.finish();
  format.time_form = read_time_form(map);
  format.occupied_word = map.require("occupied").text();
  const YamlValue free_word = map.require("free");
  format.free_word = free_word.text();
  if (format.free_word == format.occupied_word) {
    throw free_word.error("must differ from `occupied`");
  }
  format.clock = read_local_clock(map);
  if (const auto rule = map.find("charging")) {
    format.charging = read_charging_rule(*rule);
  }
  map.finish();
  return format;
}

}  // namespace evbal
