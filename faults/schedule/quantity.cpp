#include "faults/schedule/quantity.hpp"

#include "common/clock.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace evbal {
namespace {

/// How a distribution is written.
struct LawWords {
  Law law;
  const char* name;
  const char* centre;  ///< null if it has none
  const char* spread;
  bool plain_spread;  ///< without a unit
  bool for_times;     ///< makes sense for a time of day
};

constexpr std::array<LawWords, 4> laws{{
    {Law::uniform, "uniform", nullptr, nullptr, false, true},
    {Law::normal, "normal", "mean", "sd", false, true},
    {Law::lognormal, "lognormal", "median", "sigma", true, false},
    {Law::exponential, "exponential", "mean", nullptr, false, false},
}};

double amount(const YamlValue& value, Unit unit) {
  switch (unit) {
    case Unit::minutes:
      return value.duration();
    case Unit::time_of_day:
      return value.time_of_day();
    case Unit::number:
      break;
  }
  return value.number();
}

std::string shown(double amount, Unit unit) {
  if (unit == Unit::time_of_day) {
    return time_of_day(DayClock{.start = 0}, static_cast<int>(amount));
  }
  std::ostringstream out;
  out << amount << (unit == Unit::minutes ? "min" : "");
  return out.str();
}

double within(const YamlValue& value, Unit unit, Range range) {
  const double x = amount(value, unit);
  if (x < range.low || x > range.high) {
    throw value.error("`" + value.text() + "` is out of range; give a value from " + shown(range.low, unit) + " to " +
                      shown(range.high, unit));
  }
  return x;
}

double positive(const YamlValue& value, double x) {
  if (x <= 0.0) {
    throw value.error("`" + value.text() + "` is out of range; it must be greater than 0");
  }
  return x;
}

const LawWords& read_law(const YamlMap& named, Unit unit) {
  std::vector<std::string> known;
  for (const auto& words : laws) {
    if (unit == Unit::time_of_day && !words.for_times) {
      continue;
    }
    if (named.keys() == std::vector<std::string>{words.name}) {
      return words;
    }
    known.emplace_back(words.name);
  }
  std::string all;
  for (const auto& name : known) {
    all += (all.empty() ? "`" : ", `") + name + "`";
  }
  const std::string given = named.keys().empty() ? "" : named.keys().front();
  throw named.value().error("expected a value or one distribution of " + all + did_you_mean(given, known));
}

}  // namespace

Quantity read_quantity(const YamlValue& value, Unit unit, Range range) {
  Quantity quantity;
  if (!value.is_map()) {
    quantity.centre = within(value, unit, range);
    if (unit == Unit::minutes && quantity.centre != std::floor(quantity.centre)) {
      throw value.error("`" + value.text() + "` must be whole minutes");
    }
    quantity.range = {quantity.centre, quantity.centre};
    return quantity;
  }
  YamlMap named(value);
  const LawWords& words = read_law(named, unit);
  quantity.law = words.law;
  YamlMap map(named.require(words.name));
  if (words.centre != nullptr) {
    const auto centre = map.require(words.centre);
    quantity.centre = within(centre, unit, range);
    if (words.law != Law::normal) {
      positive(centre, quantity.centre);
    }
  }
  if (words.spread != nullptr) {
    const auto spread = map.require(words.spread);
    const bool plain = words.plain_spread || unit == Unit::number;
    quantity.spread = positive(spread, amount(spread, plain ? Unit::number : Unit::minutes));
  }
  const auto bound = [&](const char* key, double otherwise) {
    const auto given = words.law == Law::uniform ? map.require(key) : map.find(key);
    return given ? within(*given, unit, range) : otherwise;
  };
  quantity.range = {bound("min", range.low), bound("max", range.high)};
  if (quantity.range.low > quantity.range.high) {
    throw map.value().error("min is greater than max; exchange them");
  }
  map.finish();
  return quantity;
}

Range Quantity::likely() const {
  constexpr double normal_99 = 2.3263;  // 99 % of a standard normal lie below it
  constexpr double exponential_1 = 0.01005;
  constexpr double exponential_99 = 4.6052;  // as of an exponential of mean 1
  Range most = range;
  switch (law) {
    case Law::fixed:
    case Law::uniform:
      break;
    case Law::normal:
      most = {centre - normal_99 * spread, centre + normal_99 * spread};
      break;
    case Law::lognormal:
      most = {centre * std::exp(-normal_99 * spread), centre * std::exp(normal_99 * spread)};
      break;
    case Law::exponential:
      most = {exponential_1 * centre, exponential_99 * centre};
      break;
  }
  return {std::clamp(most.low, range.low, range.high), std::clamp(most.high, range.low, range.high)};
}

double Quantity::draw(RandomStream& stream) const {
  double x = centre;
  switch (law) {
    case Law::fixed:
      break;
    case Law::uniform:
      x = stream.uniform(range.low, range.high);
      break;
    case Law::normal:
      x = centre + spread * stream.normal();
      break;
    case Law::lognormal:
      x = centre * std::exp(spread * stream.normal());
      break;
    case Law::exponential:
      x = stream.exponential(centre);
      break;
  }
  return std::clamp(x, range.low, range.high);
}

}  // namespace evbal
