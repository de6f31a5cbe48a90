#include "agents/city/city.hpp"
#include "agents/city/table.hpp"
#include "common/yaml.hpp"

#include <algorithm>
#include <set>

namespace evbal {
namespace {

constexpr int kMaxRegions = 5000;
constexpr double kMaxMinutes = 24.0 * 60.0;
constexpr double kMaxKm = 1000.0;

/// [low, high], ascending, each read by `read`.
template <class Read>
std::pair<double, double> read_range(const YamlValue& value, Read read) {
  const auto items = value.items();
  if (items.size() != 2) {
    throw value.error("expected two numbers, [low, high]");
  }
  const std::pair<double, double> range(read(items[0]), read(items[1]));
  if (range.first > range.second) {
    throw value.error("must ascend: [low, high]");
  }
  return range;
}

std::string read_date(const YamlValue& value) {
  const std::string date = value.text();
  const bool shaped = date.size() == 10 && date[4] == '-' && date[7] == '-' &&
                      std::count_if(date.begin(), date.end(), [](char c) { return c >= '0' && c <= '9'; }) == 8;
  if (!shaped) {
    throw value.error("`" + date + "` is no date; write it like 2008-06-03");
  }
  return date;
}

std::vector<std::string> read_dates(const YamlValue& value) {
  std::vector<std::string> dates;
  for (const auto& item : value.items()) {
    dates.push_back(read_date(item));
    if (dates.size() > 1 && dates.back() <= dates[dates.size() - 2]) {
      throw item.error("`" + dates.back() + "` must come after the date before it");
    }
  }
  return dates;
}

void read_days(const YamlValue& value, City& city) {
  YamlMap map(value);
  city.train_days = read_dates(map.require("train"));
  city.test_days = read_dates(map.require("test"));
  const YamlValue holidays = map.require("holidays");
  city.holidays = read_dates(holidays);
  map.finish();
  std::merge(city.train_days.begin(), city.train_days.end(), city.test_days.begin(), city.test_days.end(),
             std::back_inserter(city.days));
  const auto twice = std::adjacent_find(city.days.begin(), city.days.end());
  if (twice != city.days.end()) {
    throw value.error("`" + *twice + "` is a day for training and for testing; choose one");
  }
  if (city.days.empty()) {
    throw value.error("a city needs at least one day");
  }
  for (const auto& date : city.holidays) {
    if (!std::binary_search(city.days.begin(), city.days.end(), date)) {
      throw holidays.error("`" + date + "` is not on record");
    }
  }
}

FleetAssumption read_fleet(const YamlValue& value) {
  YamlMap map(value);
  FleetAssumption fleet;
  fleet.vehicles = map.require("vehicles").integer(0, 1'000'000);
  fleet.battery_kwh = map.require("battery_kwh").number(1.0, 1000.0);
  fleet.km_per_kwh = map.require("km_per_kwh").number(0.1, 100.0);
  std::tie(fleet.initial_charge_low, fleet.initial_charge_high) =
      read_range(map.require("initial_charge"), [](const YamlValue& share) { return share.number(0.0, 1.0); });
  map.finish();
  return fleet;
}

ChargingAssumption read_charging(const YamlValue& value) {
  YamlMap map(value);
  ChargingAssumption charging;
  charging.power_kw = map.require("power_kw").number(0.1, 10'000.0);
  const YamlValue quantiles = map.require("session_quantiles");
  for (const auto& item : quantiles.items()) {
    charging.session_quantiles.push_back(item.duration());
    if (charging.session_quantiles.back() < 1.0 || charging.session_quantiles.back() > kMaxMinutes) {
      throw item.error("`" + item.text() + "` is no session length; give 1min to 24h");
    }
  }
  if (charging.session_quantiles.size() < 2 ||
      !std::is_sorted(charging.session_quantiles.begin(), charging.session_quantiles.end())) {
    throw quantiles.error("expected at least two durations, ascending");
  }
  map.finish();
  return charging;
}

PassengerAssumption read_passengers(const YamlValue& value) {
  YamlMap map(value);
  PassengerAssumption passengers;
  std::tie(passengers.patience_low, passengers.patience_high) =
      read_range(map.require("patience"), [](const YamlValue& minutes) { return minutes.duration(); });
  map.finish();
  return passengers;
}

/// Longitude, latitude: the order of GeoJSON.
LatLon read_position(const YamlValue& value) {
  const auto items = value.items();
  if (items.size() != 2) {
    throw value.error("expected a position, [longitude, latitude]");
  }
  return {items[1].number(-90.0, 90.0), items[0].number(-180.0, 180.0)};
}

std::vector<LatLon> read_ring(const YamlValue& value) {
  std::vector<LatLon> ring;
  for (const auto& position : value.items()) {
    ring.push_back(read_position(position));
  }
  if (ring.size() < 4 || ring.front().lat != ring.back().lat || ring.front().lon != ring.back().lon) {
    throw value.error("a ring has at least four positions, the last equal to the first");
  }
  ring.pop_back();
  return ring;
}

void expect_type(YamlMap& map, const std::string& type) {
  map.require("type").one_of({type});
}

Region read_region(const YamlValue& feature) {
  YamlMap map(feature);
  expect_type(map, "Feature");
  YamlMap properties(map.require("properties"));
  Region region;
  region.name = properties.require("name").text();
  region.centroid = read_position(properties.require("centroid"));
  properties.finish();
  YamlMap geometry(map.require("geometry"));
  expect_type(geometry, "MultiPolygon");
  for (const auto& polygon : geometry.require("coordinates").items()) {
    const auto rings = polygon.items();
    if (rings.size() != 1) {
      throw polygon.error("expected one ring; regions have no holes");
    }
    region.outline.push_back(read_ring(rings.front()));
  }
  if (region.outline.empty()) {
    throw feature.error("a region needs an outline");
  }
  geometry.finish();
  map.finish();
  return region;
}

std::vector<Region> read_regions(const std::filesystem::path& file) {
  YamlMap map(YamlValue::load(file));
  expect_type(map, "FeatureCollection");
  std::vector<Region> regions;
  std::set<std::string> names;
  for (const auto& feature : map.require("features").items()) {
    regions.push_back(read_region(feature));
    if (regions.back().name.empty() || !names.insert(regions.back().name).second) {
      throw feature.error("region name `" + regions.back().name + "` is empty or given twice");
    }
  }
  map.finish();
  return regions;
}

Station read_station(const YamlValue& value, const std::vector<std::string>& region_names) {
  YamlMap map(value);
  Station station;
  station.name = map.require("name").text();
  station.region = static_cast<int>(map.require("region").one_of(region_names));
  station.points = map.require("points").integer(1, 10'000);
  station.place = {map.require("lat").number(-90.0, 90.0), map.require("lon").number(-180.0, 180.0)};
  map.finish();
  return station;
}

std::vector<Station> read_stations(const YamlValue& value, const std::vector<Region>& regions) {
  std::vector<std::string> region_names;
  for (const auto& region : regions) {
    region_names.push_back(region.name);
  }
  std::vector<Station> stations;
  std::set<std::string> names;
  for (const auto& item : value.items()) {
    stations.push_back(read_station(item, region_names));
    if (!names.insert(stations.back().name).second) {
      throw item.error("station name `" + stations.back().name + "` is given twice");
    }
  }
  return stations;
}

void read_travel(const std::filesystem::path& file, City& city) {
  const int n = city.size();
  city.km = Eigen::MatrixXd::Zero(n, n);
  city.minutes = Eigen::MatrixXd::Zero(n, n);
  PackTable table(file, "from,to,km,minutes");
  for (int from = 0; from < n; ++from) {
    for (int to = 0; to < n; ++to) {
      const std::string pair = std::to_string(from) + "," + std::to_string(to);
      if (!table.next()) {
        throw table.error("ends before pair " + pair + "; every pair needs a line");
      }
      if (table.integer(0, 0, n - 1) != from || table.integer(1, 0, n - 1) != to) {
        throw table.error("expected pair " + pair + "; pairs are sorted and complete");
      }
      city.km(from, to) = table.number(2, 0.001, kMaxKm);
      city.minutes(from, to) = table.number(3, 1.0, kMaxMinutes);
    }
  }
  if (table.next()) {
    throw table.error("more lines than pairs of " + std::to_string(n) + " regions");
  }
}

void read_clock(YamlMap& map, City& city) {
  city.day_start = map.require("day_start").time_of_day();
  const YamlValue step = map.require("step");
  city.step_minutes = step.whole_minutes();
  if (city.day_start >= 24 * 60 || (24 * 60 - city.day_start) % city.step_minutes != 0) {
    throw step.error("step must divide the time from day_start to midnight");
  }
}

}  // namespace

City read_city(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) {
    throw bad_input(folder.string(), 0, "is no city pack; give a folder with a city.yaml");
  }
  YamlMap map(YamlValue::load(folder / "city.yaml"));
  map.require("format").one_of({"evbal-city-1"});
  City city;
  city.folder = folder;
  city.name = map.require("name").text();
  city.source = map.require("source").text();
  read_clock(map, city);
  const YamlValue count = map.require("regions");
  city.regions = read_regions(folder / "regions.geojson");
  if (count.integer(1, kMaxRegions) != city.size()) {
    throw count.error("regions.geojson has " + std::to_string(city.size()) + " regions");
  }
  read_days(map.require("days"), city);
  city.fleet = read_fleet(map.require("fleet"));
  city.charging = read_charging(map.require("charging"));
  city.passengers = read_passengers(map.require("passengers"));
  city.stations = read_stations(map.require("stations"), city.regions);
  map.finish();
  read_travel(folder / "travel.csv", city);
  return city;
}

}  // namespace evbal
