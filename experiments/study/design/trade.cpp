#include "experiments/study/design/trade.hpp"

#include "experiments/study/design/finished_day.hpp"

#include <algorithm>

namespace evbal {

std::vector<std::string> traded_metrics() {
  return {"idle_km", "idle_km_after_7", "lost", "lost_after_7"};
}

std::optional<std::string> traded_for(const std::string& cost) {
  const std::string late = "_after_7";
  const std::string suffix = cost.ends_with(late) ? late : "";
  const std::string name = cost.substr(0, cost.size() - suffix.size());
  return name == "idle_km" ? std::optional("lost" + suffix)
         : name == "lost"  ? std::optional("idle_km" + suffix)
                           : std::nullopt;
}

bool adds_up(const std::string& metric) {
  const std::vector<std::string> sums = additive_metrics();
  const std::string name = metric.substr(0, metric.find("_after_7"));
  return std::find(sums.begin(), sums.end(), name) != sums.end() || name == "charger_wait_min" || name == "objective";
}

}  // namespace evbal
