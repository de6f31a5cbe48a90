#pragma once

#include "common/yaml.hpp"

#include <cstdint>
#include <vector>

namespace evbal {

/// Which days of a study are to have a bound (docs/bound.md): those without faults, of these seeds.
struct BoundWish {
  std::vector<double> prices{};        ///< km a lost passenger, ascending: points of the bound
  std::vector<std::uint64_t> seeds{};  ///< of the days
};

/// Reads `prices` and `seeds`. Throws Error{bad_input}.
BoundWish read_bound_wish(const YamlValue& value);

}  // namespace evbal
