#include "experiments/study/design/finished_day.hpp"

#include "experiments/metrics/columns.hpp"

namespace evbal {

std::vector<std::string> additive_metrics() {
  std::vector<std::string> names;
  const auto add = [&](const char* name, auto) { names.emplace_back(name); };
  add("idle_km", 0.0);
  columns(add, Unfairness{});
  columns(add, Flows{});
  return names;
}

std::vector<std::string> finished_metrics() {
  std::vector<std::string> names = metric_names();
  for (const auto& name : additive_metrics()) {
    names.push_back(name + "_after_7");
  }
  return names;
}

}  // namespace evbal
