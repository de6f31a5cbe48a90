#include "agents/world/city.hpp"
#include "agents/world/factors.hpp"
#include "agents/world/pack_keys.hpp"
#include "agents/world/regions_file.hpp"
#include "agents/world/stations_yaml.hpp"
#include "common/clock.hpp"
#include "common/contract.hpp"
#include "common/decimal.hpp"
#include "common/files.hpp"
#include "common/new_folder.hpp"
#include "common/table_text.hpp"

namespace evbal {
namespace {

constexpr auto one_line = YamlWriter::Layout::one_line;

void write_dates(YamlWriter& yaml, const std::string& key, const std::vector<std::string>& dates) {
  yaml.key(key).begin_list(one_line);
  for (const auto& date : dates) {
    yaml.word(date);
  }
  yaml.end_list();
}

/// `regions` comes last: a truncated file lacks it.
std::string city_yaml(const City& city) {
  YamlWriter yaml;
  yaml.key("format").word("evbal-city-1").key("name").text(city.name).key("source").text(city.source);
  yaml.key("day_start").text(time_of_day({.start = 0}, city.day_start)).key("step").minutes(city.step_minutes);
  yaml.key("days").begin_map();
  write_dates(yaml, "train", city.train_days);
  write_dates(yaml, "test", city.test_days);
  write_dates(yaml, "holidays", city.holidays);
  yaml.end_map().key("fleet").begin_map().key("vehicles").number(city.fleet.vehicles);
  yaml.key("battery_kwh").number(city.fleet.battery_kwh).key("km_per_kwh").number(city.fleet.km_per_kwh);
  yaml.key("initial_charge").begin_list(one_line).number(city.fleet.initial_charge_low);
  yaml.number(city.fleet.initial_charge_high).end_list();
  write_placement(yaml, city.fleet.placement);
  yaml.end_map();
  yaml.key("charging").begin_map().key("power_kw").number(city.charging.power_kw);
  yaml.key("session_quantiles").begin_list(one_line);
  for (const double minutes : city.charging.session_quantiles) {
    yaml.minutes(minutes);
  }
  yaml.end_list().end_map().key("passengers").begin_map().key("patience").begin_list(one_line);
  yaml.minutes(city.passengers.patience_low).minutes(city.passengers.patience_high).end_list().end_map();
  write_stations(yaml, city.stations, city.regions);
  if (city.factors) {
    write_factors(yaml, *city.factors);
  }
  return yaml.key("regions").number(city.size()).finish();
}

std::string travel_csv(const City& city) {
  std::string text = "from,to,km,minutes\n";
  for (int from = 0; from < city.size(); ++from) {
    for (int to = 0; to < city.size(); ++to) {
      text += csv_row({decimal(from), decimal(to), decimal(city.km(from, to)), decimal(city.minutes(from, to))});
    }
  }
  return text;
}

/// The total at the end shows a truncated file.
std::string demand_csv(const DemandDay& day) {
  std::string text = "step,origin,destination,trips\n";
  long long total = 0;
  for (std::size_t step = 0; step < day.steps.size(); ++step) {
    for (const auto& count : day.steps[step]) {
      text += csv_row({decimal(step), decimal(count.origin), decimal(count.destination), decimal(count.trips)});
      total += count.trips;
    }
  }
  return text + csv_row({"end", "", "", decimal(total)});
}

}  // namespace

void write_city(const City& city, const std::vector<DemandDay>& days, const std::filesystem::path& folder) {
  EVBAL_EXPECT(days.size() == (city.factors ? 0 : city.days.size()),
               "the demand of each day, and none of a city of factors");
  NewFolder pack(folder);
  std::error_code ignored;  // the files would say
  std::filesystem::create_directory(pack.path() / "demand", ignored);
  write_file(pack.path() / "city.yaml", city_yaml(city));
  write_file(pack.path() / "regions.geojson", regions_geojson(city.regions));
  if (city.factors) {
    write_factor_tables(city, pack.path());
  } else {
    write_file(pack.path() / "travel.csv", travel_csv(city));
  }
  for (const auto& day : days) {
    write_file(pack.path() / "demand" / (day.date + ".csv"), demand_csv(day));
  }
  pack.keep();
}

}  // namespace evbal
