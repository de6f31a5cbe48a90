#include "tools/ingest/session_format.hpp"

#include "tools/ingest/time_pattern.hpp"

namespace evbal {
namespace {

SessionFormat session_format_of(const YamlValue& value) {
  YamlMap map(value);
  SessionFormat format = read_session_format(map);
  map.finish();
  return format;
}

}  // namespace

SessionFormat read_session_format(YamlMap& map) {
  SessionFormat format;
  format.table = read_table_format(map);
  YamlMap columns(map.require("columns"));
  format.start = add_columns(format.table, columns.require("start"));
  format.end = add_columns(format.table, columns.require("end"));
  if (const auto charger = columns.find("charger")) {
    format.charger = add_column(format.table, *charger);
  }
  columns.finish();
  format.time = read_time_pattern(map.require("time"));
  return format;
}

SessionFormat read_session_format(const std::filesystem::path& file) {
  return session_format_of(YamlValue::load(file));
}

SessionFormat dundee_session_format() {
  return session_format_of(
      YamlValue::parse("columns: {start: [Start Date, Start Time], end: [End Date, End Time], charger: Model}\n"
                       "time: \"%d/%m/%Y %H:%M\"\n",
                       "dundee.yaml"));
}

}  // namespace evbal
