#include "agents/world/city.hpp"
#include "agents/world/factors.hpp"
#include "agents/world/pack_table.hpp"
#include "agents/world/pack_text.hpp"
#include "agents/world/regions_file.hpp"
#include "common/contract.hpp"
#include "common/new_folder.hpp"

#include <sstream>

namespace evbal {
namespace {

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
      << stations_yaml(city.stations, city.regions) << (city.factors ? factors_yaml(*city.factors) : "")
      << "regions: " << city.size() << "\n";
  return out.str();
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

}  // namespace

void write_city(const City& city, const std::vector<DemandDay>& days, const std::filesystem::path& folder) {
  EVBAL_EXPECT(days.size() == (city.factors ? 0 : city.days.size()),
               "the demand of each day, and none of a city of factors");
  NewFolder pack(folder);
  std::error_code ignored;  // the files would say
  std::filesystem::create_directory(pack.path() / "demand", ignored);
  write_text(pack.path() / "city.yaml", city_yaml(city));
  write_text(pack.path() / "regions.geojson", regions_geojson(city.regions));
  if (city.factors) {
    write_factor_tables(city, pack.path());
  } else {
    write_text(pack.path() / "travel.csv", travel_csv(city));
  }
  for (const auto& day : days) {
    write_text(pack.path() / "demand" / (day.date + ".csv"), demand_csv(day));
  }
  pack.keep();
}

}  // namespace evbal
