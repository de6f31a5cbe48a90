#include "tools/gps/ingest_gps.hpp"

#include "agents/world/regions_file.hpp"
#include "common/decimal.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/table_text.hpp"
#include "tools/fit/transition_table.hpp"
#include "tools/gps/track.hpp"
#include "tools/records/record_place.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace evbal {
namespace {

/// A table that is written row by row and counts its rows.
class OutTable {
 public:
  OutTable(const std::filesystem::path& file, const std::vector<std::string>& header) : file_(file) {
    file_.write(csv_row(header));
  }

  void add(const std::vector<std::string>& row) {
    file_.write(csv_row(row));
    ++rows_;
  }

  long long rows() const { return rows_; }

  void keep() { file_.keep(); }

 private:
  NewFile file_;
  long long rows_ = 0;
};

/// Sorts what vehicles did into tables.
class Tables {
 public:
  Tables(const TrackMap& map, const std::filesystem::path& folder)
      : map_(map),
        folder_(folder),
        counter_(static_cast<int>(map.regions.size())),
        trips_(folder / "trips" / "trips.csv",
               {"cab", "pickup_unix", "pickup_lat", "pickup_lon", "dropoff_unix", "dropoff_lat", "dropoff_lon"}),
        vacant_(folder / "vacant.csv",
                {"cab", "from_unix", "from_lat", "from_lon", "to_unix", "to_lat", "to_lon", "km", "ended_by"}) {
    if (map.station_map) {
      charging_.emplace(folder / "charging.csv",
                        std::vector<std::string>{"cab", "station", "region", "arrival_unix", "start_unix", "end_unix"});
    }
  }

  void add(const std::string& vehicle, const Fix& fix, bool goes_on) {
    auto known = tracks_.find(vehicle);
    if (known == tracks_.end()) {
      known = tracks_.emplace(vehicle, map_).first;
    } else if (!goes_on) {
      end(vehicle, known->second);
      known = tracks_.emplace_hint(tracks_.erase(known), vehicle, map_);
    }
    write(vehicle, known->second.add(fix, counter_));
  }

  void finish() {
    for (auto& [vehicle, track] : tracks_) {
      end(vehicle, track);
    }
    expect_transitions();
    trips_.keep();
    vacant_.keep();
    if (charging_) {
      charging_->keep();
    }
    if (map_.region_map) {
      transitions_ = write_transitions(counter_.periods(), map_.regions, folder_ / "transitions.csv");
    }
  }

  std::string report(const FixCount& count) const {
    std::ostringstream out;
    out << "files read: " << count.files << ", rows: " << count.read << "\n";
    if (count.backwards > 0) {
      out << "  files from the newest to the oldest row, read backwards: " << count.backwards << "\n";
    }
    out << count.dropped.report() << "vehicles: " << tracks_.size() << "\n"
        << "trips: " << trips_.rows() << "\n"
        << "  dropped, under way when a vehicle's records begin or end: " << cut_off_ << "\n"
        << "vacant moves: " << vacant_.rows() << ", " << std::llround(vacant_km_) << " km\n";
    if (charging_) {
      out << "charging stops: " << charging_->rows() << "\n";
    }
    return out.str() + transitions_ + outside_.report();
  }

 private:
  /// Throws if no transition was seen, since no vehicle was in the regions.
  void expect_transitions() const {
    const auto& periods = counter_.periods();
    const bool seen = std::any_of(periods.begin(), periods.end(), [](const TransitionCounts& counts) {
      return counts.vacant.sum() + counts.occupied.sum() > 0.0;
    });
    if (!seen && outside_.rows() > 0) {
      throw bad_input("no vehicle is in a region for half an hour; a region lies at " +
                      place_text(map_.regions.front().centroid));
    }
  }

  void end(const std::string& vehicle, Track& track) {
    write(vehicle, track.finish(counter_));
    cut_off_ += track.cut_off();
  }

  void write(const std::string& vehicle, const TrackEvents& events) {
    static const std::vector<std::string> ends{"pickup", "gap", "records"};
    if (const auto& ride = events.ride) {
      trips_.add({vehicle, decimal(ride->pickup.time), decimal(ride->pickup.place.lat), decimal(ride->pickup.place.lon),
                  decimal(ride->dropoff.time), decimal(ride->dropoff.place.lat), decimal(ride->dropoff.place.lon)});
    }
    if (const auto& move = events.vacant) {
      vacant_.add({vehicle, decimal(move->from.time), decimal(move->from.place.lat), decimal(move->from.place.lon),
                   decimal(move->to.time), decimal(move->to.place.lat), decimal(move->to.place.lon),
                   decimal(std::round(move->km * 1000.0) / 1000.0), ends[static_cast<std::size_t>(move->end)]});
      vacant_km_ += move->km;
    }
    for (const Outside& moment : events.outside) {
      outside_.add("a vehicle or the end of its ride outside the regions",
                   "vehicle " + shown(vehicle) + " at " + decimal(moment.time), place_text(moment.place));
    }
    for (const ChargingStop& stop : events.stops) {
      const Station& station = map_.stations[stop.station];
      charging_->add({vehicle, station.name, map_.regions[station.region].name, decimal(stop.arrival),
                      decimal(stop.start), decimal(stop.end)});
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
  Dropped outside_;          ///< moments that are in no transition
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
      sources.gps, format,
      [&](const std::string& vehicle, const Fix& fix, bool goes_on) { tables.add(vehicle, fix, goes_on); }, tell);
  try {
    tables.finish();
  } catch (const Error& error) {
    throw with_report(error, tables.report(count));
  }
  return tables.report(count);
}

}  // namespace evbal
