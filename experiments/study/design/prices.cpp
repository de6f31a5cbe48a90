#include "experiments/study/design/prices.hpp"

#include <algorithm>

namespace evbal {

Prices read_prices(const YamlValue& value) {
  const std::vector<std::string> names = finished_metrics();
  Prices prices;
  YamlMap map(value);
  for (const auto& metric : map.keys()) {
    const YamlValue price = map.require(metric);
    if (std::find(names.begin(), names.end(), metric) == names.end()) {
      throw price.error("`" + metric + "` is no metric" + did_you_mean(metric, names) + "; see docs/metrics.md");
    }
    prices.emplace_back(metric, price.number());
  }
  if (prices.empty()) {
    throw value.error("prices nothing; give at least one metric its price");
  }
  return prices;
}

double priced(const Prices& prices, const FinishedDay& day) {
  double sum = 0.0;
  for (const auto& [metric, price] : prices) {
    sum += price * day.totals.at(metric);
  }
  return sum;
}

}  // namespace evbal
