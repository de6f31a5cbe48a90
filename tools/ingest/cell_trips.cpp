#include "tools/ingest/cell_trips.hpp"

#include "common/error.hpp"
#include "tools/records/row_tally.hpp"

#include <cmath>
#include <cstddef>

namespace evbal {
namespace {

constexpr int kMostTrips = 1'000'000;

class CellReader {
 public:
  explicit CellReader(const OdFormat& format)
      : format_(format),
        no_count_(column_name(format.table, format.trips) + " is no number of trips, 1 to " +
                  std::to_string(kMostTrips)) {
    for (const std::size_t column : {format.from_lat, format.from_lon, format.to_lat, format.to_lon}) {
      no_number_[column] = column_name(format.table, column) + " is no number";
    }
  }

  CellTrips read(const std::filesystem::path& file) {
    CellTrips all;
    try {
      RawTable table(file, format_.table);
      RowTally tally(table, all.dropped);
      while (table.next()) {
        ++all.rows;
        tally.keeps(add(table, all));
      }
      tally.finish();
    } catch (const Error& error) {
      throw with_report(error, all.report());
    }
    return all;
  }

 private:
  RowFault add(const RawTable& row, CellTrips& all) {
    int from = 0;
    int to = 0;
    RowFault fault = row.fault();
    fault = fault ? fault : cell(row, format_.from_lat, format_.from_lon, all, from);
    fault = fault ? fault : cell(row, format_.to_lat, format_.to_lon, all, to);
    if (fault) {
      return fault;
    }
    const auto trips = row.integer(format_.trips);
    if (!trips || *trips < 1 || *trips > kMostTrips) {
      return {no_count_, row.text(format_.trips)};
    }
    all.trips[{from, to}] += *trips;
    return {};
  }

  RowFault cell(const RawTable& row, std::size_t lat_column, std::size_t lon_column, CellTrips& all, int& cell) {
    const auto lat = row.number(lat_column);
    const auto lon = row.number(lon_column);
    if (!lat || !lon) {
      const std::size_t column = lat ? lon_column : lat_column;
      return {no_number_[column], row.text(column)};
    }
    const LatLon place{format_.first.lat + *lat * format_.step.lat, format_.first.lon + *lon * format_.step.lon};
    if (!(std::abs(place.lat) <= 90.0 && std::abs(place.lon) <= 180.0)) {
      return {"a cell that is not on the earth", row.text(std::abs(place.lat) <= 90.0 ? lon_column : lat_column)};
    }
    const auto [known, is_new] = known_.try_emplace({*lat, *lon}, static_cast<int>(all.cells.size()));
    if (is_new) {
      all.cells.push_back(place);
    }
    cell = known->second;
    return {};
  }

  const OdFormat& format_;
  std::string no_count_;
  std::map<std::size_t, std::string> no_number_;  ///< by column
  std::map<std::pair<double, double>, int> known_;
};

}  // namespace

std::string CellTrips::report() const {
  return "trip rows read: " + std::to_string(rows) + "\n" + dropped.report();
}

CellTrips read_cell_trips(const std::filesystem::path& file, const OdFormat& format) {
  return CellReader(format).read(file);
}

}  // namespace evbal
