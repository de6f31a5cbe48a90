#include "tools/gps/ingest_gps.hpp"

#include "agents/world/pack_table.hpp"
#include "agents/world/regions_file.hpp"
#include "tools/gps/track.hpp"
#include "tools/gps/transition_table.hpp"

#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

namespace evbal {
namespace {

/// A table that is written row by row.
class OutTable {
 public:
  OutTable(const std::filesystem::path& file, const std::string& header) : file_(file), out_(file, std::ios::binary) {
    out_ << header << "\n";
  }

  void add(const std::string& row) {
    out_ << row << "\n";
    ++rows_;
  }

  long long rows() const { return rows_; }

  void close() {
    out_.close();
    if (!out_) {
      throw run_failed(file_.string() + ": cannot be written");
    }
  }

 private:
  std::filesystem::path file_;
  std::ofstream out_;
  long long rows_ = 0;
};

std::string time_and_place(const Fix& fix) {
  return "," + std::to_string(fix.time) + "," + decimal(fix.place.lat) + "," + decimal(fix.place.lon);
}

/// Sorts what vehicles did into tables.
class Tables {
 public:
  Tables(const TrackMap& map, const std::filesystem::path& folder)
      : map_(map),
        folder_(folder),
        counter_(static_cast<int>(map.regions.size())),
        trips_(folder / "trips" / "trips.csv",
               "cab,pickup_unix,pickup_lat,pickup_lon,dropoff_unix,dropoff_lat,dropoff_lon"),
        vacant_(folder / "vacant.csv", "cab,from_unix,from_lat,from_lon,to_unix,to_lat,to_lon,km,ended_by") {
    if (map.station_map) {
      charging_.emplace(folder / "charging.csv", "cab,station,region,arrival_unix,start_unix,end_unix");
    }
  }

  void add(const std::string& vehicle, const Fix& fix) {
    const auto known = tracks_.find(vehicle);
    Track& track = known == tracks_.end() ? tracks_.emplace(vehicle, map_).first->second : known->second;
    write(vehicle, track.add(fix, counter_));
  }

  void finish() {
    for (auto& [vehicle, track] : tracks_) {
      write(vehicle, track.finish(counter_));
      cut_off_ += track.cut_off();
    }
    trips_.close();
    vacant_.close();
    if (charging_) {
      charging_->close();
    }
    if (map_.region_map) {
      transitions_ = write_transitions(counter_, map_.regions, folder_ / "transitions.csv");
    }
  }

  std::string report(const FixCount& count) const {
    std::ostringstream out;
    out << "files read: " << count.files << ", rows: " << count.read << "\n";
    for (const auto& [reason, rows] : count.dropped) {
      out << "  dropped, " << reason << ": " << rows << "\n";
    }
    out << "vehicles: " << tracks_.size() << "\n"
        << "trips: " << trips_.rows() << "\n"
        << "  dropped, under way when a vehicle's records begin or end: " << cut_off_ << "\n"
        << "vacant moves: " << vacant_.rows() << ", " << std::llround(vacant_km_) << " km\n";
    if (charging_) {
      out << "charging stops: " << charging_->rows() << "\n";
    }
    return out.str() + transitions_;
  }

 private:
  void write(const std::string& vehicle, const TrackEvents& events) {
    static const std::vector<std::string> ends{"pickup", "gap", "records"};
    if (const auto& ride = events.ride) {
      trips_.add(vehicle + time_and_place(ride->pickup) + time_and_place(ride->dropoff));
    }
    if (const auto& move = events.vacant) {
      vacant_.add(vehicle + time_and_place(move->from) + time_and_place(move->to) + "," +
                  decimal(std::round(move->km * 1000.0) / 1000.0) + "," + ends[static_cast<std::size_t>(move->end)]);
      vacant_km_ += move->km;
    }
    for (const ChargingStop& stop : events.stops) {
      const Station& station = map_.stations[stop.station];
      charging_->add(vehicle + "," + station.name + "," + map_.regions[station.region].name + "," +
                     std::to_string(stop.arrival) + "," + std::to_string(stop.start) + "," + std::to_string(stop.end));
    }
  }

  const TrackMap& map_;
  std::filesystem::path folder_;
  TransitionCounter counter_;
  OutTable trips_;
  OutTable vacant_;
  std::optional<OutTable> charging_;
  std::map<std::string, Track, std::less<>> tracks_;
  long long cut_off_ = 0;
  double vacant_km_ = 0.0;
  std::string transitions_;  ///< its part of the report
};

TrackMap read_map(const GpsSources& sources, const GpsFormat& format) {
  if (!sources.stations.empty() && sources.regions.empty()) {
    throw bad_input("stations lie in regions: give --regions as well");
  }
  std::vector<Region> regions;
  std::vector<Station> stations;
  if (!sources.regions.empty()) {
    regions = read_regions(sources.regions);
  }
  if (!sources.stations.empty()) {
    stations = read_stations(sources.stations, regions);
  }
  return {std::move(regions), std::move(stations), format.clock, format.charging};
}

}  // namespace

std::string ingest_gps(const GpsSources& sources, const std::filesystem::path& folder,
                       const std::function<void(const FixProgress&)>& tell) {
  const GpsFormat format = read_gps_format(sources.format);
  const TrackMap map = read_map(sources, format);
  std::error_code ignored;  // opening a table in it will fail
  std::filesystem::create_directories(folder / "trips", ignored);
  Tables tables(map, folder);
  const FixCount count = for_each_fix(
      sources.gps, format, [&](const std::string& vehicle, const Fix& fix) { tables.add(vehicle, fix); }, tell);
  tables.finish();
  return tables.report(count);
}

}  // namespace evbal
