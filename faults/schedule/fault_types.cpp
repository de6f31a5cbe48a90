#include "faults/schedule/fault_types.hpp"

#include <algorithm>
#include <cassert>

namespace evbal {

const std::vector<FaultType>& fault_types() {
  static const std::vector<FaultType> types = {
      {"demand.scale", EffectType::demand_scale, MagnitudeUnit::factor, true, false},
      {"charger.outage", EffectType::charger_outage, MagnitudeUnit::points, false, true},
  };
  return types;
}

std::vector<std::string> fault_type_names() {
  std::vector<std::string> names;
  for (const auto& type : fault_types()) {
    names.push_back(type.name);
  }
  return names;
}

const FaultType& fault_type(EffectType effect) {
  const auto& types = fault_types();
  const auto found = std::find_if(types.begin(), types.end(), [&](const auto& type) { return type.effect == effect; });
  assert(found != types.end());
  return *found;
}

const std::vector<std::string>& on_start_words() {
  static const std::vector<std::string> words = {"drain", "evict"};
  return words;
}

}  // namespace evbal
