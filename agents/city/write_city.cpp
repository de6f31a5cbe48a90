#include "agents/city/city.hpp"
#include "agents/city/table.hpp"

#include <cassert>
#include <fstream>
#include <sstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// A text as JSON and YAML both read it.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
    }
    out += c == '\n' ? ' ' : c;
  }
  return out + "\"";
}

template <class Items, class Show>
std::string list(const Items& items, Show show) {
  std::string out = "[";
  for (const auto& item : items) {
    out += (out.size() > 1 ? ", " : "") + show(item);
  }
  return out + "]";
}

std::string dates(const std::vector<std::string>& days) {
  return list(days, [](const std::string& date) { return date; });
}

std::string minutes(double amount) {
  return decimal(amount) + "min";
}

std::string time_of_day(int minute) {
  const auto two = [](int number) { return (number < 10 ? "0" : "") + std::to_string(number); };
  return "\"" + two(minute / 60) + ":" + two(minute % 60) + "\"";
}

std::string position(LatLon point) {
  return "[" + decimal(point.lon) + ", " + decimal(point.lat) + "]";
}

/// `regions` comes last: a truncated file lacks it.
std::string city_yaml(const City& city) {
  std::ostringstream out;
  out << "format: evbal-city-1\n"
      << "name: " << quoted(city.name) << "\n"
      << "source: " << quoted(city.source) << "\n"
      << "day_start: " << time_of_day(city.day_start) << "\n"
      << "step: " << city.step_minutes << "min\n"
      << "days:\n"
      << "  train: " << dates(city.train_days) << "\n"
      << "  test: " << dates(city.test_days) << "\n"
      << "  holidays: " << dates(city.holidays) << "\n"
      << "fleet:\n"
      << "  vehicles: " << city.fleet.vehicles << "\n"
      << "  battery_kwh: " << decimal(city.fleet.battery_kwh) << "\n"
      << "  km_per_kwh: " << decimal(city.fleet.km_per_kwh) << "\n"
      << "  initial_charge: [" << decimal(city.fleet.initial_charge_low) << ", "
      << decimal(city.fleet.initial_charge_high) << "]\n"
      << "charging:\n"
      << "  power_kw: " << decimal(city.charging.power_kw) << "\n"
      << "  session_quantiles: " << list(city.charging.session_quantiles, minutes) << "\n"
      << "passengers:\n"
      << "  patience: [" << minutes(city.passengers.patience_low) << ", " << minutes(city.passengers.patience_high)
      << "]\n"
      << "stations:" << (city.stations.empty() ? " []" : "") << "\n";
  for (const auto& station : city.stations) {
    out << "  - {name: " << quoted(station.name) << ", region: " << quoted(city.regions[station.region].name)
        << ", points: " << station.points << ", lat: " << decimal(station.place.lat)
        << ", lon: " << decimal(station.place.lon) << "}\n";
  }
  out << "regions: " << city.size() << "\n";
  return out.str();
}

/// One polygon of a MultiPolygon, closed.
std::string polygon(const std::vector<LatLon>& ring) {
  std::vector<LatLon> closed = ring;
  closed.push_back(ring.front());
  return "[" + list(closed, position) + "]";
}

std::string regions_geojson(const City& city) {
  std::string out = "{\"type\": \"FeatureCollection\", \"features\": [\n";
  for (int i = 0; i < city.size(); ++i) {
    const Region& region = city.regions[i];
    out += "{\"type\": \"Feature\", \"properties\": {\"name\": " + quoted(region.name) +
           ", \"centroid\": " + position(region.centroid) +
           "}, \"geometry\": {\"type\": \"MultiPolygon\", \"coordinates\": " + list(region.outline, polygon) + "}}" +
           (i + 1 < city.size() ? ",\n" : "\n");
  }
  return out + "]}\n";
}

std::string travel_csv(const City& city) {
  std::string out = "from,to,km,minutes\n";
  for (int from = 0; from < city.size(); ++from) {
    for (int to = 0; to < city.size(); ++to) {
      out += std::to_string(from) + "," + std::to_string(to) + "," + decimal(city.km(from, to)) + "," +
             decimal(city.minutes(from, to)) + "\n";
    }
  }
  return out;
}

/// The total at the end shows a truncated file.
std::string demand_csv(const DemandDay& day) {
  std::string out = "step,origin,destination,trips\n";
  long long total = 0;
  for (std::size_t step = 0; step < day.steps.size(); ++step) {
    for (const auto& count : day.steps[step]) {
      out += std::to_string(step) + "," + std::to_string(count.origin) + "," + std::to_string(count.destination) + "," +
             std::to_string(count.trips) + "\n";
      total += count.trips;
    }
  }
  return out + "end,,," + std::to_string(total) + "\n";
}

void write_file(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) {
    throw run_failed(file.string() + ": cannot be written");
  }
}

void write_files(const City& city, const std::vector<DemandDay>& days, const fs::path& folder) {
  fs::create_directories(folder / "demand");
  write_file(folder / "city.yaml", city_yaml(city));
  write_file(folder / "regions.geojson", regions_geojson(city));
  write_file(folder / "travel.csv", travel_csv(city));
  for (const auto& day : days) {
    write_file(folder / "demand" / (day.date + ".csv"), demand_csv(day));
  }
}

}  // namespace

void write_city(const City& city, const std::vector<DemandDay>& days, const fs::path& folder) {
  assert(city.days.size() == days.size());
  const fs::path target = fs::absolute(folder / "").lexically_normal().parent_path();
  if (fs::exists(target) && !(fs::is_directory(target) && fs::is_empty(target))) {
    throw bad_input(folder.string(), 0, "exists and is not an empty folder; give a new one");
  }
  const fs::path partial = target.string() + ".partial";
  try {
    fs::remove_all(partial);
    write_files(city, days, partial);
    fs::rename(partial, target);
  } catch (const fs::filesystem_error& error) {
    std::error_code ignored;
    fs::remove_all(partial, ignored);
    throw run_failed(folder.string() + ": cannot be written: " + error.code().message());
  } catch (const Error&) {
    std::error_code ignored;
    fs::remove_all(partial, ignored);
    throw;
  }
}

}  // namespace evbal
