#pragma once

#include "agents/protocol/messages.hpp"

#include <limits>
#include <type_traits>

namespace evbal {

/// Regions first..last; all of them unless said otherwise.
struct RegionRange {
  int first = std::numeric_limits<int>::min();  ///< first of them
  int last = std::numeric_limits<int>::max();   ///< last of them

  /// Whether a region is one of them.
  bool contains(int region) const { return first <= region && region <= last; }
};

/// Whether an item of a message's list says something to one of the regions: what arrives or acts there, and moves that
/// start there. An item of another kind does.
template <class Item>
bool concerns(const RegionRange& regions, const Item& item) {
  if constexpr (std::is_same_v<Item, Arrival> || std::is_same_v<Item, UnderWay> || std::is_same_v<Item, Effect>) {
    return regions.contains(item.region);
  } else if constexpr (std::is_same_v<Item, Move>) {
    return regions.contains(item.from);
  } else {
    return true;
  }
}

}  // namespace evbal
