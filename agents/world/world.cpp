#include "agents/world/world.hpp"

#include "agents/world/pack_keys.hpp"
#include "common/installation.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> demand_models = {"recorded", "poisson"};

constexpr const char* pack_variable = "EVBAL_CITIES";

/// Where packs go by name, first hit first.
std::vector<fs::path> pack_folders() {
  std::vector<fs::path> folders;
  if (const char* own = std::getenv(pack_variable)) {
    std::istringstream list(own);
    for (std::string folder; std::getline(list, folder, ':');) {
      folders.emplace_back(folder);
    }
  }
  if (auto shipped = shipped_folder("cities"); !shipped.empty()) {
    folders.push_back(std::move(shipped));
  }
  return folders;
}

std::optional<fs::path> shipped_pack(const std::string& name) {
  for (const auto& folder : pack_folders()) {
    std::error_code unreadable;
    if (fs::is_directory(folder / name, unreadable)) {
      return folder / name;
    }
  }
  return std::nullopt;
}

/// The folder of a pack given by name or by path, the latter from `base`; none if there is neither.
std::optional<fs::path> pack_folder(const std::string& given, const fs::path& base) {
  const auto shipped = given.find('/') == std::string::npos ? shipped_pack(given) : std::nullopt;
  std::error_code unreadable;
  return shipped || !fs::is_directory(base / given, unreadable) ? shipped : base / given;
}

std::string no_pack(const std::string& given) {
  return "city `" + given + "` is neither a shipped pack nor a folder" + did_you_mean(given, pack_names());
}

/// A process reads a pack once: a sweep asks for the same ones for each of its days.
const City& pack_in(const fs::path& folder) {
  static std::mutex mutex;
  static std::map<fs::path, City> packs;
  const std::scoped_lock lock(mutex);
  const auto known = packs.find(folder);
  return known != packs.end() ? known->second : packs.emplace(folder, read_city(folder)).first->second;
}

City read_pack(const YamlValue& value) {
  const auto folder = pack_folder(value.text(), fs::path(value.file()).parent_path());
  if (!folder) {
    throw value.error(no_pack(value.text()));
  }
  return pack_in(*folder);
}

DemandDay read_day(const YamlValue& value, const City& city) {
  const std::string date = value.text();
  if (std::find(city.days.begin(), city.days.end(), date) == city.days.end()) {
    throw value.error("no demand of `" + date + "` is on record in " + city.name + "; choose a day" +
                      (city.days.empty() ? "" : " from " + city.days.front() + " to " + city.days.back()) +
                      did_you_mean(date, city.days));
  }
  return read_demand(city, date);
}

// The scenario's `clock`, or its city's where it has none: `city_value` is what names the city.
DayClock read_clock(const std::optional<YamlValue>& value, const YamlValue& city_value, const City& city) {
  DayClock clock;
  clock.start = city.day_start;
  if (!value) {
    if (const auto wrong = clock.validate(); !wrong.empty()) {
      throw city_value.error("the days of " + city.name + " begin at " + time_of_day(clock, 0) + ", and " + wrong +
                             ": give the scenario a `clock`");
    }
    return clock;
  }
  YamlMap map(*value);
  const auto time = [&](const char* key, int& field) {
    if (const auto given = map.find(key)) {
      field = given->time_of_day();
    }
  };
  const auto minutes = [&](const char* key, int& field) {
    if (const auto given = map.find(key)) {
      field = given->whole_minutes();
    }
  };
  time("start", clock.start);
  time("end", clock.end);
  minutes("tick", clock.tick);
  minutes("step", clock.step);
  minutes("plan_every", clock.plan_every);
  map.finish();
  if (const auto wrong = clock.validate(); !wrong.empty()) {
    throw value->error(wrong);
  }
  if (clock.start < city.day_start) {
    throw value->error("the day starts before the city's records do");
  }
  return clock;
}

void override_number(YamlMap& map, const char* key, double low, double high, double& field) {
  if (const auto given = map.find(key)) {
    field = given->number(low, high);
  }
}

/// A range `[low, high]`, each end read by `read`.
template <class Read>
void override_range(YamlMap& map, const char* key, double& low, double& high, Read read) {
  const auto given = map.find(key);
  if (!given) {
    return;
  }
  const std::vector<YamlValue> ends = given->items();
  if (ends.size() != 2 || read(ends[0]) > read(ends[1])) {
    throw given->error("expected `[low, high]`, low not above high");
  }
  low = read(ends[0]);
  high = read(ends[1]);
}

void override_fleet(const YamlValue& value, FleetAssumption& fleet) {
  YamlMap map(value);
  if (const auto vehicles = map.find("vehicles")) {
    fleet.vehicles = vehicles->integer(0, 1000000);
  }
  override_number(map, "battery_kwh", 0.1, 10000.0, fleet.battery_kwh);
  override_number(map, "km_per_kwh", 0.01, 1000.0, fleet.km_per_kwh);
  override_range(map, "initial_charge", fleet.initial_charge_low, fleet.initial_charge_high,
                 [](const YamlValue& end) { return end.number(0.0, 1.0); });
  if (const auto placement = map.find("placement")) {
    fleet.placement = read_placement(*placement);
  }
  map.finish();
}

void override_charging(const YamlValue& value, ChargingAssumption& charging) {
  YamlMap map(value);
  override_number(map, "power_kw", 0.01, 10000.0, charging.power_kw);
  if (const auto quantiles = map.find("session_quantiles")) {
    std::vector<double> minutes;
    for (const auto& item : quantiles->items()) {
      minutes.push_back(read_session_minutes(item));
    }
    if (minutes.size() < 2 || !std::is_sorted(minutes.begin(), minutes.end())) {
      throw quantiles->error("expected at least two durations in ascending order, such as [12min, 40min, 90min]");
    }
    charging.session_quantiles = std::move(minutes);
  }
  if (const auto top_up = map.find("top_up")) {
    charging.top_up = top_up->boolean();
  }
  map.finish();
}

void override_passengers(const YamlValue& value, PassengerAssumption& passengers) {
  YamlMap map(value);
  override_range(map, "patience", passengers.patience_low, passengers.patience_high, read_patience);
  map.finish();
}

/// A region by its position or its name.
int read_region(const YamlValue& value, const City& city) {
  const std::string given = value.text();
  if (!given.empty() && given.find_first_not_of("-0123456789") == std::string::npos) {
    return value.integer(0, city.size() - 1);
  }
  std::vector<std::string> names;
  for (const auto& region : city.regions) {
    names.push_back(region.name);
  }
  return static_cast<int>(value.one_of(names));
}

/// A station of the scenario. One that the pack has in the same region keeps its place, another stands at the
/// region's centroid.
Station read_station(const YamlValue& value, const City& city) {
  YamlMap map(value);
  const YamlValue region = map.require("region");
  Station station;
  station.name = map.require("name").text();
  station.region = read_region(region, city);
  station.points = map.require("points").integer(0, 10000);
  map.finish();
  station.place = city.regions[station.region].centroid;
  for (const auto& known : city.stations) {
    if (known.name == station.name && known.region == station.region) {
      station.place = known.place;
    }
  }
  return station;
}

std::vector<Station> read_stations(const YamlValue& value, const City& city) {
  std::vector<Station> stations;
  for (const auto& item : value.items()) {
    const Station station = read_station(item, city);
    for (const auto& other : stations) {
      if (other.name == station.name) {
        throw item.error("station `" + station.name + "` is given twice");
      }
    }
    stations.push_back(station);
  }
  return stations;
}

std::string pack_name(const City& city) {
  const std::string name = city.folder.filename().string();
  const auto shipped = shipped_pack(name);
  std::error_code none;
  return shipped && fs::equivalent(*shipped, city.folder, none) ? name : fs::absolute(city.folder).string();
}

std::string time_text(int minute_of_day) {
  return time_of_day({.start = 0}, minute_of_day);
}

}  // namespace

MessageBounds bounds_of(const World& world) {
  return {.regions = world.city.size(),
          .vehicles = world.city.fleet.vehicles,
          .battery_kwh = world.city.fleet.battery_kwh,
          .longest_trip = world.city.minutes.maxCoeff(),
          .clock = world.clock};
}

void share_pack_folders() {
  std::string list;
  for (const auto& folder : pack_folders()) {
    list += (list.empty() ? "" : ":") + fs::absolute(folder).string();
  }
  setenv(pack_variable, list.c_str(), 1);
}

std::vector<std::string> pack_names() {
  std::set<std::string> names;
  for (const auto& folder : pack_folders()) {
    std::error_code unreadable;
    for (fs::directory_iterator entry(folder, unreadable), end; !unreadable && entry != end;
         entry.increment(unreadable)) {
      if (fs::exists(entry->path() / "city.yaml", unreadable)) {
        names.insert(entry->path().filename().string());
      }
    }
  }
  return {names.begin(), names.end()};
}

City find_city(const std::string& name) {
  const auto folder = pack_folder(name, {});
  if (!folder) {
    throw bad_input(no_pack(name));
  }
  return read_city(*folder);
}

World read_world(YamlMap& scenario) {
  World world;
  const YamlValue city = scenario.require("city");
  world.city = read_pack(city);
  world.day = read_day(scenario.require("day"), world.city);
  world.seed = scenario.require("seed").seed();
  if (const auto demand = scenario.find("demand")) {
    world.demand = static_cast<DemandModel>(demand->one_of(demand_models));
  }
  world.clock = read_clock(scenario.find("clock"), city, world.city);
  if (const auto fleet = scenario.find("fleet")) {
    override_fleet(*fleet, world.city.fleet);
  }
  if (const auto charging = scenario.find("charging")) {
    override_charging(*charging, world.city.charging);
  }
  if (const auto passengers = scenario.find("passengers")) {
    override_passengers(*passengers, world.city.passengers);
  }
  if (const auto stations = scenario.find("stations")) {
    world.city.stations = read_stations(*stations, world.city);
  }
  return world;
}

void write_world(YamlWriter& yaml, const World& world) {
  constexpr auto one_line = YamlWriter::Layout::one_line;
  const City& city = world.city;
  const DayClock& clock = world.clock;
  yaml.key("city").text(pack_name(city)).key("day").text(world.day.date);
  yaml.key("seed").number(world.seed).key("demand").word(demand_models[static_cast<std::size_t>(world.demand)]);
  yaml.key("clock").begin_map(one_line);
  yaml.key("start").text(time_text(clock.start)).key("end").text(time_text(clock.end));
  yaml.key("tick").minutes(clock.tick).key("step").minutes(clock.step);
  yaml.key("plan_every").minutes(clock.plan_every).end_map();
  yaml.key("fleet").begin_map(one_line).key("vehicles").number(city.fleet.vehicles);
  yaml.key("battery_kwh").number(city.fleet.battery_kwh).key("km_per_kwh").number(city.fleet.km_per_kwh);
  yaml.key("initial_charge").begin_list().number(city.fleet.initial_charge_low);
  yaml.number(city.fleet.initial_charge_high).end_list();
  write_placement(yaml, city.fleet.placement);
  yaml.end_map();
  yaml.key("charging").begin_map(one_line).key("power_kw").number(city.charging.power_kw);
  yaml.key("session_quantiles").begin_list();
  for (const double minutes : city.charging.session_quantiles) {
    yaml.minutes(minutes);
  }
  yaml.end_list().key("top_up").boolean(city.charging.top_up).end_map();
  yaml.key("passengers").begin_map(one_line).key("patience").begin_list();
  yaml.minutes(city.passengers.patience_low).minutes(city.passengers.patience_high).end_list().end_map();
  yaml.key("stations").begin_list();
  for (const auto& station : city.stations) {
    yaml.begin_map(one_line).key("name").text(station.name).key("region").number(station.region);
    yaml.key("points").number(station.points).end_map();
  }
  yaml.end_list();
}

}  // namespace evbal
