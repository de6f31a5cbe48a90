#pragma once

#include "tools/ingest/trip_format.hpp"
#include "tools/ingest/zone_places.hpp"
#include "tools/records/local_clock.hpp"
#include "tools/records/raw_table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// A trip as a row tells it.
struct TripRow {
  long long pickup = 0;   ///< UTC seconds
  long long dropoff = 0;  ///< UTC seconds
  LatLon from;            ///< of the pick-up
  LatLon to;              ///< of the drop-off
};

/// The columns of a trip's start or end, and what is wrong with them.
class TripEndColumns {
 public:
  /// Both must outlive this. `zones` are those of which the table tells the names, if it does.
  TripEndColumns(const TripFormat& format, const TripFormat::End& end, const std::vector<Zone>& zones);

  /// Reads UTC seconds into `time`: the first after `after` where clocks show it twice.
  RowFault read_time(const RawTable& table, const LocalClock& clock, long long after, long long& time) const;

  /// Reads a place; in a zone it is drawn by `draw`.
  RowFault read_place(const RawTable& table, const ZonePlaces& zones, std::uint64_t draw, LatLon& place) const;

  /// The time as the table shows it.
  std::string_view time(const RawTable& table) const { return table.text(end_.time); }

  /// The place or zone as the table shows it.
  std::string place(const RawTable& table) const;

 private:
  const TripFormat& format_;
  const TripFormat::End& end_;
  std::string no_time_;  ///< reasons
  std::string no_lat_;
  std::string no_lon_;
  std::string no_zone_;
};

/// Reads the rows of tables of trips.
class TripRows {
 public:
  /// All must outlive this.
  TripRows(const TripFormat& format, const std::vector<Zone>& zones, const LocalClock& clock);

  /// Reads the current row into `row`. `number` is the row's, which places in zones are drawn by. The fault's reason is
  /// valid as long as this.
  RowFault read(const RawTable& table, long long number, TripRow& row) const;

  /// The columns of the trip's start.
  const TripEndColumns& pickup() const { return pickup_; }

  /// The columns of the trip's end.
  const TripEndColumns& dropoff() const { return dropoff_; }

 private:
  TripEndColumns pickup_;
  TripEndColumns dropoff_;
  ZonePlaces zones_;
  const LocalClock& clock_;
};

}  // namespace evbal
