#include "tools/ingest/ingest_stations.hpp"

#include "agents/world/geometry.hpp"
#include "agents/world/pack_table.hpp"
#include "common/plain_text.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace evbal {
namespace {

constexpr int kMostPoints = 10'000;

/// Reads rows into stations, or gives the reason why it cannot.
class StationReader {
 public:
  StationReader(const StationFormat& format, const std::vector<Outline>& outlines, double snap_m)
      : format_(format), map_(outlines), snap_m_(snap_m) {}

  /// Empty if a station was added, else the reason.
  std::string add(const RawTable& row) {
    if (!row.whole()) {
      return malformed_row;
    }
    const auto lat = parse_number(row.text(format_.lat));
    const auto lon = parse_number(row.text(format_.lon));
    const auto points = parse_integer(row.text(format_.points));
    const std::string name(row.text(format_.name));
    if (!lat || !lon || !points || std::abs(*lat) > 90.0 || std::abs(*lon) > 180.0 || *points > kMostPoints ||
        name.empty() || !line_complaint(name).empty()) {
      return malformed_row;
    }
    if (*points < 1) {
      return "no points";
    }
    const auto nearest = map_.nearest({*lat, *lon});
    if (nearest.metres > snap_m_) {
      return "outside the regions";
    }
    if (!names_.insert(name).second) {
      return "name given before";
    }
    snapped += nearest.metres > 0.0 ? 1 : 0;
    stations.push_back({name, nearest.outline, static_cast<int>(*points), {*lat, *lon}});
    return "";
  }

  std::vector<Station> stations;
  long long snapped = 0;

 private:
  const StationFormat& format_;
  OutlineMap map_;
  double snap_m_;
  std::set<std::string> names_;
};

}  // namespace

StationFormat read_station_format(YamlMap& map) {
  StationFormat format;
  format.table = read_table_format(map);
  YamlMap columns(map.require("columns"));
  format.name = add_column(format.table, columns.require("name"));
  format.lat = add_column(format.table, columns.require("lat"));
  format.lon = add_column(format.table, columns.require("lon"));
  format.points = add_column(format.table, columns.require("points"));
  columns.finish();
  return format;
}

IngestedStations ingest_stations(const std::filesystem::path& table, const StationFormat& format,
                                 const std::vector<Region>& regions, double snap_m) {
  StationReader reader(format, outlines_of(regions), snap_m);
  RawTable rows(table, format.table);
  long long read = 0;
  std::map<std::string, long long> dropped;
  while (rows.next()) {
    ++read;
    const std::string reason = reader.add(rows);
    if (!reason.empty()) {
      ++dropped[reason];
    }
  }
  if (reader.stations.empty()) {
    throw bad_input(table.string(), 0, "has no station in a region");
  }
  std::stable_sort(reader.stations.begin(), reader.stations.end(),
                   [](const Station& a, const Station& b) { return a.region < b.region; });
  std::ostringstream out;
  out << "stations read: " << read << "\n";
  for (const auto& [reason, count] : dropped) {
    out << "  dropped, " << reason << ": " << count << "\n";
  }
  std::set<int> with_points;
  long long points = 0;
  for (const auto& station : reader.stations) {
    with_points.insert(station.region);
    points += station.points;
  }
  out << "stations used: " << reader.stations.size() << " with " << points << " points in " << with_points.size()
      << " of " << regions.size() << " regions\n"
      << "  outside all regions, moved to the nearest: " << reader.snapped << "\n";
  return {std::move(reader.stations), out.str()};
}

}  // namespace evbal
