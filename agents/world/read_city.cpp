#include "agents/world/city.hpp"
#include "agents/world/factors.hpp"
#include "agents/world/pack_keys.hpp"
#include "agents/world/pack_table.hpp"
#include "agents/world/regions_file.hpp"
#include "common/yaml.hpp"

namespace evbal {
namespace {

constexpr int kMaxRegions = 5000;
constexpr double kMaxMinutes = 24.0 * 60.0;
constexpr double kMaxKm = 1000.0;

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
  YamlMap charging(map.require("charging"));
  city.charging = read_charging(charging);
  charging.finish();
  city.passengers = read_passengers(map.require("passengers"));
  city.stations = read_stations(map.require("stations"), city.regions);
  const auto factors = map.find("factors");
  map.finish();
  if (factors) {
    city.factors = read_factors(*factors, city);
    set_travel(city);
  } else {
    read_travel(folder / "travel.csv", city);
  }
  return city;
}

}  // namespace evbal
