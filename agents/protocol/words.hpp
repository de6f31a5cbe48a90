#pragma once

#include "agents/protocol/messages.hpp"

#include <array>

namespace evbal {

/// Words for an Errand, by enumerator.
inline constexpr std::array errand_words = {"passenger", "rebalance", "charge"};

inline const char* word(Errand errand) {
  return errand_words.at(static_cast<std::size_t>(errand));
}

}  // namespace evbal
