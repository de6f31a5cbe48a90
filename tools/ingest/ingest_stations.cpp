#include "tools/ingest/ingest_stations.hpp"

#include "agents/world/geometry.hpp"
#include "common/plain_text.hpp"
#include "tools/ingest/open_charge_map.hpp"
#include "tools/ingest/point_sum.hpp"
#include "tools/ingest/raw_json.hpp"
#include "tools/ingest/station_list.hpp"
#include "tools/ingest/time_pattern.hpp"
#include "tools/records/record_place.hpp"
#include "tools/records/row_tally.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

namespace evbal {
namespace {

/// A name in one line: line breaks and tabs become blanks.
std::string one_line(std::string_view text) {
  std::string name(text);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return name;
}

/// Reads lists of stations and puts each station into its region.
class StationReader {
 public:
  StationReader(const StationFormat& format, const std::vector<Outline>& outlines, double snap_m)
      : format_(format), map_(outlines), snap_m_(snap_m) {}

  /// Reads a table or, if the format says so, an export of Open Charge Map.
  void read(const std::filesystem::path& file) {
    if (format_.open_charge_map) {
      read_charge_map(file);
    } else {
      read_table(file);
    }
  }

  StationList list;
  Dropped dropped;
  long long rows = 0;
  long long snapped = 0;
  std::optional<LatLon> first_outside;  ///< of the regions

 private:
  void read_table(const std::filesystem::path& file) {
    RawTable table(file, format_.table);
    RowTally tally(table, dropped);
    for (; table.next(); ++rows) {
      Station station;
      RowFault fault = read_row(table, station);
      tally.keeps(fault ? fault : add(std::move(station), file.string() + ":" + std::to_string(table.line())));
    }
    tally.finish();
  }

  void read_charge_map(const std::filesystem::path& file) {
    const nlohmann::json entries = read_raw_json(file, "JSON", "list");
    if (!entries.is_array()) {
      throw bad_input(file.string(), 0, "is no list of stations, such as Open Charge Map exports");
    }
    ChargeMapEntry reader;
    for (const nlohmann::json& entry : entries) {
      const std::string where = file.string() + ": entry " + std::to_string(rows++);
      Station station;
      RowFault fault = reader.read(entry, station);
      const std::string name = station.name;
      fault = fault ? fault : add(std::move(station), where);
      if (fault) {
        dropped.add(fault.reason, where, fault.value);
        continue;
      }
      for (int untold = 0; untold < reader.untold(); ++untold) {
        dropped.add("a connection without a number, beside others", where, name);
      }
    }
  }

  RowFault read_row(const RawTable& row, Station& station) const {
    if (!row.whole()) {
      return row.fault();
    }
    if (const RowFault fault = read_place(row, format_.lat, format_.lon, station.place)) {
      return fault;
    }
    PointSum sum;
    for (const std::size_t column : format_.points) {
      if (row.text(column).empty()) {
        continue;
      }
      if (const RowFault fault = sum.add(row.number(column), row.text(column))) {
        return fault;
      }
    }
    station.name = row.text(format_.name);
    return sum.total(row.text(format_.name), station.points);
  }

  /// Adds a station, or says why it cannot. The fault's value is valid until the next call.
  RowFault add(Station station, const std::string& where) {
    listed_ = station.name;
    station.name = one_line(station.name);
    if (station.name.empty()) {
      listed_ = place_text(station.place);
      return {"no name", listed_, false};
    }
    if (find_invalid_utf8(station.name) != std::string::npos) {
      return {"name is not UTF-8", listed_, false};
    }
    if (!validate_line(station.name).empty()) {
      return {"name with a control character", listed_, false};
    }
    const auto nearest = map_.nearest(station.place);
    if (nearest.metres > snap_m_) {
      first_outside = first_outside.value_or(station.place);
      return {"outside the regions", listed_, false};
    }
    snapped += nearest.metres > 0.0 ? 1 : 0;
    station.region = nearest.outline;
    list.add(station, where);
    return {};
  }

  const StationFormat& format_;
  OutlineMap map_;
  double snap_m_;
  std::string listed_;  ///< name of the last station
};

std::string used_report(const std::vector<Station>& stations, std::size_t regions) {
  std::set<int> with_points;
  long long points = 0;
  for (const auto& station : stations) {
    with_points.insert(station.region);
    points += station.points;
  }
  std::ostringstream out;
  out << "stations used: " << stations.size() << " with " << points << " points in " << with_points.size() << " of "
      << regions << " regions\n";
  return out.str();
}

}  // namespace

StationFormat read_station_format(YamlMap& map) {
  StationFormat format;
  if (const auto layout = map.find("layout")) {
    format.open_charge_map = layout->one_of({"table", "open-charge-map"}) == 1;
  }
  if (format.open_charge_map) {
    return format;
  }
  format.table = read_table_format(map);
  YamlMap columns(map.require("columns"));
  format.name = add_column(format.table, columns.require("name"));
  format.lat = add_column(format.table, columns.require("lat"));
  format.lon = add_column(format.table, columns.require("lon"));
  format.points = add_columns(format.table, columns.require("points"));
  columns.finish();
  return format;
}

IngestedStations ingest_stations(const std::filesystem::path& file, const StationFormat& format,
                                 const std::vector<Region>& regions, double snap_m) {
  StationReader reader(format, outlines_of(regions), snap_m);
  try {
    reader.read(file);
    if (reader.list.stations().empty()) {
      const auto& outside = reader.first_outside;
      throw bad_input(
          file.string(), 0,
          "has no station in a region" + (outside ? "; one lies at " + place_text(*outside) + ", a region at " +
                                                        place_text(regions.front().centroid)
                                                  : std::string()));
    }
  } catch (const Error& error) {
    throw with_report(error, reader.dropped.report());
  }
  std::vector<Station> stations = reader.list.stations();
  std::stable_sort(stations.begin(), stations.end(),
                   [](const Station& a, const Station& b) { return a.region < b.region; });
  const std::string report = "rows read: " + std::to_string(reader.rows) + "\n" + reader.dropped.report() +
                             reader.list.report() + used_report(stations, regions.size()) +
                             "  outside all regions, moved to the nearest: " + std::to_string(reader.snapped) + "\n";
  return {std::move(stations), report};
}

}  // namespace evbal
