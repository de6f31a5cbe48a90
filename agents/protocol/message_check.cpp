#include "agents/protocol/message_check.hpp"

#include "agents/protocol/reflection.hpp"
#include "common/error.hpp"
#include "common/plain_text.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <type_traits>
#include <utility>

namespace evbal {
namespace {

constexpr double most_times = 1e4;     // all factors of a kind on a region together
constexpr double most_together = 1e6;  // all other magnitudes of a kind on a region together
constexpr double most_cpu_seconds = 1e9;

/// Checks one thing after another and keeps the first that is wrong.
class Check {
 public:
  explicit Check(const MessageBounds& bounds) : bounds_(bounds) {}

  std::string wrong() const { return wrong_; }

  template <class Words>
  void that(bool holds, Words otherwise) {
    if (!holds && wrong_.empty()) {
      wrong_ = otherwise();
    }
  }

  /// At every depth of a message numbers are finite and texts are UTF-8.
  template <class Message>
  void values(const Message& message) {
    for_each_field(message, [&](std::string_view name, const auto& field) { value(name, field); });
  }

  void within(const char* what, double value, double least, double most) {
    that(value >= least && value <= most, [&] { return named(what, value); });
  }

  void region(const char* what, int region) { within(what, region, 0, bounds_.regions - 1); }
  void tick(int tick) { within("tick", tick, 0, bounds_.clock.ticks() - 1); }
  void count(const char* what, int count) { within(what, count, 0, most_together); }

  void regions(const char* what, const std::vector<std::int32_t>& list) {
    for (const int each : list) {
      region(what, each);
    }
    that(std::adjacent_find(list.begin(), list.end(), std::greater_equal{}) == list.end(),
         [&] { return std::string(what) + ": not ascending"; });
  }

  void provenance(const Provenance& made) {
    within("max_violation", made.max_violation, 0.0, std::numeric_limits<double>::max());
    within("iterations", made.iterations, 0, std::numeric_limits<std::int32_t>::max());
    for (const SensorFlag& flag : made.flags) {
      region("flag of region", flag.region);
    }
    const double distance = made.objective - made.lower_bound;
    that(made.gap * distance >= 0.0 && std::abs(made.gap) <= std::abs(distance), [&] {
      return named("gap", made.gap) + named(" between", made.objective) + named(" and its bound", made.lower_bound);
    });
  }

  void origin(const Origin& origin) {
    that(origin.process_id >= 0, [&] { return "process " + std::to_string(origin.process_id); });
    within("seconds", origin.seconds, 0.0, most_cpu_seconds);
  }

  void vehicle(const Vehicle& vehicle) {
    within("vehicle", vehicle.id, 0, bounds_.vehicles - 1);
    count("sessions", vehicle.sessions);
    within("battery_kwh", vehicle.battery_kwh, 0.0, bounds_.battery_kwh);
  }

  void effects(const std::vector<Effect>& effects) {
    std::map<std::pair<EffectType, int>, double> together;
    for (const Effect& effect : effects) {
      this->effect(effect);
      const bool factor = effect.type == EffectType::demand_scale || effect.type == EffectType::fleet_drain ||
                          effect.type == EffectType::travel_slow;
      double& all = together.try_emplace({effect.type, effect.region}, factor ? 1.0 : 0.0).first->second;
      all = factor ? all * effect.magnitude : all + std::abs(effect.magnitude);
      within("magnitude", all, 0.0, factor ? most_times : most_together);
    }
  }

 private:
  void effect(const Effect& effect) {
    const FaultFamily family = family_of(effect.type);
    const bool of_region =
        family != FaultFamily::solver && (family != FaultFamily::process || effect.process == ProcessRole::agent);
    count("fault", effect.fault);
    if (of_region) {
      region("region", effect.region);
    }
    if (effect.type == EffectType::demand_shift) {
      region("to", effect.to);
    }
    that(family != FaultFamily::sensor || effect.field != ReportField::none, [] { return "a sensor of no field"; });
    // The product of many could hide one that is none.
    within("magnitude", effect.magnitude, effect.type == EffectType::sensor_biased ? -most_together : 0.0,
           most_together);
  }

  template <class Field>
  void value(std::string_view name, const Field& field) {
    if constexpr (std::is_same_v<Field, double>) {
      that(std::isfinite(field), [&] { return named(name, field); });
    } else if constexpr (std::is_same_v<Field, std::string>) {
      constexpr auto nowhere = std::string_view::npos;
      that(find_invalid_utf8(field) == nowhere && find_control_character(field) == nowhere,
           [&] { return std::string(name) + " is no text in UTF-8"; });
    } else if constexpr (std::is_class_v<Field>) {
      values(field);
    }
  }

  template <class Item>
  void value(std::string_view name, const std::vector<Item>& items) {
    for (const auto& item : items) {
      value(name, item);
    }
  }

  static std::string named(std::string_view name, double value) {
    const bool whole = value == std::floor(value) && std::abs(value) < 1e15;
    return std::string(name) + " " + (whole ? std::to_string(static_cast<std::int64_t>(value)) : std::to_string(value));
  }

  const MessageBounds& bounds_;
  std::string wrong_;
};

void check_fate(Check& check, const Fate& fate, const MessageBounds& bounds, int end) {
  check.within("appeared", fate.appeared, 0, end - 1);
  check.region("destination", fate.destination);
  check.within("waited", fate.waited, 0, end);
  check.within("vehicle", fate.vehicle, -1, bounds.vehicles - 1);
  check.that(fate.served == (fate.vehicle >= 0), [] { return "a passenger served by no vehicle, or lost to one"; });
}

void check_car(Check& check, const Departure& car, const MessageBounds& bounds, int begin, int end) {
  check.within("minute", car.minute, begin, end - 1);
  check.region("to", car.to);
  check.within("arrival_minute", car.arrival_minute, end, end + most_times * (bounds.longest_trip + 1.0));
  check.vehicle(car.vehicle);
  check.within("km", car.km, 0.0, most_together);
}

/// Every passenger who was served rides in a car that left.
void check_rides(Check& check, const Departures& message) {
  std::multiset<int> served;
  std::multiset<int> rides;
  for (const Fate& fate : message.fates) {
    if (fate.served) {
      served.insert(fate.vehicle);
    }
  }
  for (const Departure& car : message.departures) {
    if (car.errand == Errand::passenger) {
      rides.insert(car.vehicle.id);
    }
  }
  check.that(served == rides, [] { return "passengers served and cars that left with one are not the same"; });
}

}  // namespace

std::string validate(const Faults& message, const MessageBounds& bounds) {
  Check check(bounds);
  check.values(message);
  check.tick(message.tick);
  check.effects(message.effects);
  check.origin(message.origin);
  return check.wrong();
}

std::string validate(const Tick& message, const MessageBounds& bounds) {
  Check check(bounds);
  check.values(message);
  check.tick(message.tick);
  if (!check.wrong().empty()) {
    return check.wrong();  // there is no such minute
  }
  check.regions("due", message.due);
  check.regions("unheard", message.unheard);
  check.regions("unplanned", message.unplanned);
  const int begin = bounds.clock.minute_of(message.tick);
  const int end = bounds.clock.minute_of(message.tick + 1);
  std::set<int> arrived;
  for (const Arrival& car : message.arrivals) {
    check.region("region", car.region);
    check.within("minute", car.minute, begin, end - 1);
    check.vehicle(car.vehicle);
    check.that(arrived.insert(car.vehicle.id).second,
               [&] { return "vehicle " + std::to_string(car.vehicle.id) + " twice"; });
  }
  std::int64_t vehicles = 0;
  for (const UnderWay& cars : message.under_way) {
    check.region("region", cars.region);
    check.within("minute", cars.minute, 0, bounds.clock.minutes() + most_times * (bounds.longest_trip + 1.0));
    check.within("count", cars.count, 1, bounds.vehicles);
    vehicles += cars.count;
  }
  check.within("vehicles under way", static_cast<double>(vehicles), 0, bounds.vehicles);
  check.effects(message.effects);
  return check.wrong();
}

std::string validate(const Report& message, const MessageBounds& bounds) {
  Check check(bounds);
  check.values(message);
  check.origin(message.origin);
  return check.wrong();
}

std::string validate(const Plan& message, const MessageBounds& bounds) {
  Check check(bounds);
  check.values(message);
  check.tick(message.tick);
  for (const Move& move : message.moves) {
    check.region("from", move.from);
    check.region("to", move.to);
    check.within("count", move.count, 1, bounds.vehicles);
    check.that(move.errand != Errand::passenger, [] { return "a move with a passenger"; });
  }
  check.provenance(message.provenance);
  check.origin(message.origin);
  return check.wrong();
}

std::string validate(const Departures& message, const MessageBounds& bounds) {
  Check check(bounds);
  check.values(message);
  check.tick(message.tick);
  check.region("region", message.region);
  if (!check.wrong().empty()) {
    return check.wrong();
  }
  const int begin = bounds.clock.minute_of(message.tick);
  const int end = bounds.clock.minute_of(message.tick + 1);
  for (const Departure& car : message.departures) {
    check_car(check, car, bounds, begin, end);
  }
  for (const Fate& fate : message.fates) {
    check_fate(check, fate, bounds, end);
  }
  check_rides(check, message);
  for (const Observed& seen : message.observed) {
    check.count("fault", seen.fault);
    check.count("evicted", seen.evicted);
  }
  check.within("refused", message.refused, 0, std::numeric_limits<std::int32_t>::max());
  for (const auto& [name, value] : {std::pair{"demand", message.demand},
                                    {"completions", message.completions},
                                    {"topped_up", message.topped_up},
                                    {"queue_minutes", message.queue_minutes},
                                    {"stranded", message.stranded},
                                    {"vacant", message.vacant},
                                    {"low_battery", message.low_battery},
                                    {"plugged", message.plugged},
                                    {"points", message.points},
                                    {"waiting", message.waiting},
                                    {"broken", message.broken}}) {
    check.count(name, value);
  }
  check.within("charged_kwh", message.charged_kwh, 0.0, bounds.vehicles * bounds.battery_kwh);
  check.origin(message.origin);
  return check.wrong();
}

void refuse(const std::string& sender, int tick, const std::string& wrong) {
  throw run_failed(sender + " said of tick " + std::to_string(tick) + " what cannot be: " + wrong);
}

}  // namespace evbal
