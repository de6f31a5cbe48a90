#include "experiments/record/recorded_sensor.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace evbal {
namespace {

/// What agents say of a field of a region at each tick's end; none if they do not.
std::vector<double> said_by_agents(const SQLite::Database& database, const RecordedSensor& sensor) {
  static const std::array<std::string, 5> fields = {"vacant", "low_battery", "plugged", "waiting", "demand"};
  std::vector<double> values;
  if (std::ranges::find(fields, sensor.field) != fields.end()) {
    SQLite::Statement query(database, "SELECT " + sensor.field + " FROM departures WHERE region = ? ORDER BY tick");
    query.bind(1, sensor.region);
    while (query.executeStep()) {
      values.push_back(query.getColumn(0).getDouble());
    }
  }
  return values;
}

void read_readings(const SQLite::Database& database, RecordedSensor& sensor) {
  const std::vector<double> said = said_by_agents(database, sensor);
  SQLite::Statement query(database, "SELECT r.tick, r." + sensor.field +
                                        ", f.estimate FROM reports r LEFT JOIN sensor_flags f ON f.tick = r.tick AND "
                                        "f.region = r.region AND f.field = ? WHERE r.region = ? ORDER BY r.tick");
  query.bind(1, sensor.field);
  query.bind(2, sensor.region);
  for (int before = 0; query.executeStep(); before = sensor.readings.back().tick) {
    SensorReading reading{.tick = query.getColumn(0).getInt(), .reported = query.getColumn(1).getInt()};
    if (!query.getColumn(2).isNull()) {
      reading.estimate = query.getColumn(2).getInt();
    }
    if (reading.tick > 0 && reading.tick <= std::ssize(said)) {
      const auto end = said.begin() + reading.tick;
      reading.truth = sensor.field == "demand" ? std::accumulate(said.begin() + before, end, 0.0) : *(end - 1);
    }
    sensor.readings.push_back(reading);
  }
}

}  // namespace

std::vector<RecordedSensor> read_sensors(const std::filesystem::path& file, int most) {
  const SQLite::Database database(file.string());
  std::vector<RecordedSensor> sensors;
  SQLite::Statement flagged(database,
                            "SELECT region, field FROM sensor_flags GROUP BY region, field "
                            "ORDER BY count(*) DESC, region, field LIMIT ?");
  flagged.bind(1, most);
  while (flagged.executeStep()) {
    sensors.push_back({.region = flagged.getColumn(0).getInt(), .field = flagged.getColumn(1).getString()});
  }
  for (RecordedSensor& sensor : sensors) {
    SQLite::Statement kinds(database,
                            "SELECT kind FROM sensor_flags WHERE region = ? AND field = ? GROUP BY kind "
                            "ORDER BY count(*) DESC, kind");
    kinds.bind(1, sensor.region);
    kinds.bind(2, sensor.field);
    while (kinds.executeStep()) {
      sensor.kinds.push_back(kinds.getColumn(0).getString());
    }
    read_readings(database, sensor);
  }
  return sensors;
}

}  // namespace evbal
