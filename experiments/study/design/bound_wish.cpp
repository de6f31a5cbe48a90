#include "experiments/study/design/bound_wish.hpp"

#include "experiments/study/design/study_file.hpp"

#include <algorithm>

namespace evbal {

BoundWish read_bound_wish(const YamlValue& value) {
  YamlMap map(value);
  BoundWish wish;
  const YamlValue prices = map.require("prices");
  for (const auto& item : distinct_items(prices)) {
    wish.prices.push_back(item.number(1e-3, 1e6));
  }
  if (!std::is_sorted(wish.prices.begin(), wish.prices.end())) {
    throw prices.error("prices ascend");
  }
  wish.seeds = read_seeds(map.require("seeds"));
  map.finish();
  return wish;
}

}  // namespace evbal
