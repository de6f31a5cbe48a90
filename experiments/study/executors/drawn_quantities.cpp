#include "experiments/study/executors/drawn_quantities.hpp"

#include "agents/protocol/messages.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

namespace evbal {
namespace {

constexpr long fewest_hits = 3;

/// The name without the number that each time of a fault by `arrivals` has.
std::string name_in_request(const std::string& name) {
  const auto digits = name.find_last_not_of("0123456789");
  const bool numbered = digits != std::string::npos && digits > 0 && digits + 1 < name.size() && name[digits] == '-';
  return numbered ? name.substr(0, digits) : name;
}

/// The names in the request of faults that do not strike equally often in all draws.
std::set<std::string> by_arrivals(const std::vector<Schedule>& draws) {
  std::map<std::string, std::vector<int>> times;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    for (const auto& fault : draws[i].faults) {
      auto& of_name = times[name_in_request(fault.name)];
      of_name.resize(draws.size());
      ++of_name[i];
    }
  }
  std::set<std::string> names;
  for (const auto& [name, of_draws] : times) {
    if (std::adjacent_find(of_draws.begin(), of_draws.end(), std::not_equal_to<>()) != of_draws.end()) {
      names.insert(name);
    }
  }
  return names;
}

/// What one draw has of a fault, by quantity.
using Amounts = std::map<std::string, double>;

Amounts none() {
  return {{"times", 0.0}, {"minutes", 0.0}, {"magnitude", 0.0}, {"regions", 0.0}};
}

void add(const Fault& fault, int day_start, Amounts& amounts) {
  const auto first = amounts.emplace("start", fault.start + day_start).first;
  first->second = std::min(first->second, static_cast<double>(fault.start + day_start));
  amounts["times"] += 1.0;
  amounts["minutes"] += fault.duration;
  amounts["magnitude"] += std::accumulate(fault.magnitudes.begin(), fault.magnitudes.end(), 0.0);
  for (const int region : fault.regions) {
    if (region != no_region) {
      amounts["regions"] += 1.0;
      amounts["in region " + std::to_string(region)] = 1.0;
    }
  }
}

bool differs(const std::string& quantity, const std::vector<double>& values) {
  if (quantity.starts_with("in region ")) {
    const auto hits = std::count(values.begin(), values.end(), 1.0);
    return hits >= fewest_hits && static_cast<long>(values.size()) - hits >= fewest_hits;
  }
  std::set<double> known;
  for (const double value : values) {
    if (!std::isnan(value)) {
      known.insert(value);
    }
  }
  return known.size() > 1;
}

}  // namespace

std::vector<DrawnQuantity> drawn_quantities(const std::vector<Schedule>& draws, int day_start) {
  const std::set<std::string> arriving = by_arrivals(draws);
  std::vector<std::string> names;
  std::map<std::string, std::vector<Amounts>> amounts;
  std::map<std::string, std::set<std::string>> quantities;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    for (const auto& fault : draws[i].faults) {
      const std::string request = name_in_request(fault.name);
      const std::string& name = arriving.contains(request) ? request : fault.name;
      const auto [of_fault, is_new] = amounts.emplace(name, std::vector<Amounts>(draws.size(), none()));
      if (is_new) {
        names.push_back(name);
      }
      add(fault, day_start, of_fault->second[i]);
      for (const auto& [quantity, value] : of_fault->second[i]) {
        quantities[name].insert(quantity);
      }
    }
  }
  std::vector<DrawnQuantity> all;
  for (const auto& name : names) {
    for (const auto& quantity : quantities[name]) {
      DrawnQuantity drawn{.fault = name, .quantity = quantity, .values = {}};
      for (const auto& of_draw : amounts[name]) {
        const auto found = of_draw.find(quantity);
        const double absent = quantity == "start" ? std::numeric_limits<double>::quiet_NaN() : 0.0;
        drawn.values.push_back(found == of_draw.end() ? absent : found->second);
      }
      if (differs(quantity, drawn.values)) {
        all.push_back(std::move(drawn));
      }
    }
  }
  return all;
}

}  // namespace evbal
