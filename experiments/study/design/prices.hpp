#pragma once

#include "common/yaml.hpp"
#include "experiments/study/design/finished_day.hpp"

#include <string>
#include <utility>
#include <vector>

namespace evbal {

/// What each of several metrics costs.
using Prices = std::vector<std::pair<std::string, double>>;

/// Reads `{idle_km: 1, lost: 20}`. Throws Error{bad_input}.
Prices read_prices(const YamlValue& value);

/// What a day costs by these.
double priced(const Prices& prices, const FinishedDay& day);

}  // namespace evbal
