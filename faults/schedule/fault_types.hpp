#pragma once

#include "agents/protocol/messages.hpp"

#include <string>
#include <vector>

namespace evbal {

/// What a fault's magnitude measures.
enum class MagnitudeUnit {
  factor,  ///< a number, at least 0
  points,  ///< charging points of a region that has some
};

/// A kind of fault: its name in a schedule and the fields that it has beside those of every fault.
struct FaultType {
  std::string name;
  EffectType effect = EffectType::demand_scale;
  MagnitudeUnit magnitude = MagnitudeUnit::factor;
  bool ramp = false;      ///< comes and goes gradually
  bool on_start = false;  ///< cars at the points that fail: evict or drain
};

/// Every kind that there is. A new kind is a row here and an effect in the plant.
const std::vector<FaultType>& fault_types();

/// Names of fault_types(), in their order.
std::vector<std::string> fault_type_names();

const FaultType& fault_type(EffectType effect);

/// Largest factor that a schedule may ask for.
constexpr double max_factor = 100.0;

/// The words of `on_start` in the order of OnStart.
const std::vector<std::string>& on_start_words();

}  // namespace evbal
