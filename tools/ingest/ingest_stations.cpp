#include "tools/ingest/ingest_stations.hpp"

#include "agents/world/geometry.hpp"
#include "common/plain_text.hpp"
#include "tools/ingest/station_list.hpp"
#include "tools/ingest/time_pattern.hpp"
#include "tools/records/record_place.hpp"
#include "tools/records/row_tally.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>

namespace evbal {
namespace {

constexpr long long kMostPoints = 10'000;

/// A name in one line: line breaks and tabs become blanks.
std::string one_line(std::string_view text) {
  std::string name(text);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return name;
}

/// Reads rows into stations.
class StationReader {
 public:
  StationReader(const StationFormat& format, const std::vector<Outline>& outlines, double snap_m)
      : format_(format), map_(outlines), snap_m_(snap_m) {}

  /// Adds the station of a row, or says why it cannot.
  RowFault add(const RawTable& row) {
    if (!row.whole()) {
      return row.fault();
    }
    Station station;
    RowFault fault = read_place(row, format_.lat, format_.lon, station.place);
    fault = fault ? fault : read_points(row, station.points);
    fault = fault ? fault : read_name(row, station.name);
    if (fault) {
      return fault;
    }
    const auto nearest = map_.nearest(station.place);
    if (nearest.metres > snap_m_) {
      return {"outside the regions", row.text(format_.name), false};
    }
    snapped += nearest.metres > 0.0 ? 1 : 0;
    station.region = nearest.outline;
    list.add(station, row.file() + ":" + std::to_string(row.line()));
    return {};
  }

  StationList list;
  long long snapped = 0;

 private:
  RowFault read_points(const RawTable& row, int& points) const {
    bool told = false;
    long long sum = 0;
    for (const std::size_t column : format_.points) {
      if (row.text(column).empty()) {
        continue;
      }
      const auto number = row.integer(column);
      if (!number || std::abs(*number) > kMostPoints) {
        return {"no number of points, a whole number up to 10000", row.text(column)};
      }
      sum += *number;
      told = true;
    }
    if (!told) {
      return {"no number of points told", row.text(format_.name), false};
    }
    if (sum < 1 || sum > kMostPoints) {
      return {sum < 1 ? "no points" : "more than 10000 points", row.text(format_.name), false};
    }
    points = static_cast<int>(sum);
    return {};
  }

  RowFault read_name(const RawTable& row, std::string& name) const {
    name = one_line(row.text(format_.name));
    if (name.empty()) {
      return {"no name", row.text(format_.lat), false};
    }
    if (find_invalid_utf8(name) != std::string::npos) {
      return {"name is not UTF-8", row.text(format_.name), false};
    }
    if (!validate_line(name).empty()) {
      return {"name with a control character", row.text(format_.name), false};
    }
    return {};
  }

  const StationFormat& format_;
  OutlineMap map_;
  double snap_m_;
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
  format.table = read_table_format(map);
  YamlMap columns(map.require("columns"));
  format.name = add_column(format.table, columns.require("name"));
  format.lat = add_column(format.table, columns.require("lat"));
  format.lon = add_column(format.table, columns.require("lon"));
  format.points = add_columns(format.table, columns.require("points"));
  columns.finish();
  return format;
}

IngestedStations ingest_stations(const std::filesystem::path& table, const StationFormat& format,
                                 const std::vector<Region>& regions, double snap_m) {
  StationReader reader(format, outlines_of(regions), snap_m);
  Dropped dropped;
  long long read = 0;
  try {
    RawTable rows(table, format.table);
    RowTally tally(rows, dropped);
    for (; rows.next(); ++read) {
      tally.keeps(reader.add(rows));
    }
    tally.finish();
    if (reader.list.stations().empty()) {
      throw bad_input(table.string(), 0, "has no station in a region");
    }
  } catch (const Error& error) {
    throw with_report(error, dropped.report());
  }
  std::vector<Station> stations = reader.list.stations();
  std::stable_sort(stations.begin(), stations.end(),
                   [](const Station& a, const Station& b) { return a.region < b.region; });
  const std::string report = "rows read: " + std::to_string(read) + "\n" + dropped.report() + reader.list.report() +
                             used_report(stations, regions.size()) +
                             "  outside all regions, moved to the nearest: " + std::to_string(reader.snapped) + "\n";
  return {std::move(stations), report};
}

}  // namespace evbal
