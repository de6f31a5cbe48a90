#include "agents/world/pack_keys.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace evbal {
namespace {

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
  std::string date = value.text();
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

}  // namespace

void read_clock(YamlMap& map, City& city) {
  city.day_start = map.require("day_start").time_of_day();
  const YamlValue step = map.require("step");
  city.step_minutes = step.whole_minutes();
  if (city.day_start >= 24 * 60 || (24 * 60 - city.day_start) % city.step_minutes != 0) {
    throw step.error("step must divide the time from day_start to midnight");
  }
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
  if (const auto placement = map.find("placement")) {
    fleet.placement = read_placement(*placement);
  }
  map.finish();
  return fleet;
}

FleetPlacement read_placement(const YamlValue& value) {
  return static_cast<FleetPlacement>(value.one_of({"pick_ups", "even"}));
}

void write_placement(YamlWriter& yaml, FleetPlacement placement) {
  if (placement == FleetPlacement::even) {
    yaml.key("placement").word("even");
  }
}

ChargingAssumption read_charging(YamlMap& map) {
  ChargingAssumption charging;
  charging.power_kw = map.require("power_kw").number(0.1, 10'000.0);
  const YamlValue quantiles = map.require("session_quantiles");
  for (const auto& item : quantiles.items()) {
    charging.session_quantiles.push_back(read_session_minutes(item));
  }
  if (charging.session_quantiles.size() < 2 ||
      !std::is_sorted(charging.session_quantiles.begin(), charging.session_quantiles.end())) {
    throw quantiles.error("expected at least two durations, ascending");
  }
  return charging;
}

double read_patience(const YamlValue& value) {
  return value.duration(0.0, 24.0 * 60.0);
}

double read_session_minutes(const YamlValue& value) {
  return value.duration(1.0, 24.0 * 60.0);
}

PassengerAssumption read_passengers(const YamlValue& value) {
  YamlMap map(value);
  PassengerAssumption passengers;
  std::tie(passengers.patience_low, passengers.patience_high) = read_range(map.require("patience"), read_patience);
  map.finish();
  return passengers;
}

}  // namespace evbal
