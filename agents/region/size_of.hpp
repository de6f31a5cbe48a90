#pragma once

namespace evbal {

/// The length of a list as messages count: in int.
int size_of(const auto& list) {
  return static_cast<int>(list.size());
}

}  // namespace evbal
