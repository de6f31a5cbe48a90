#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/protocol/reflection.hpp"

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace evbal {

/// An enum whose enumerators are called in schedules, record and bridge as they are here. Types of fault have names of
/// their own (faults/schedule/fault_types.hpp).
template <class Enum>
concept Worded = std::is_enum_v<Enum> && !std::same_as<Enum, EffectType>;

/// The word for an enumerator.
template <Worded Enum>
constexpr std::string_view word(Enum value) {
  return enumerator_names<Enum>.at(static_cast<std::size_t>(value));
}

/// The words for all enumerators, in their order.
template <Worded Enum>
std::vector<std::string> words() {
  return {enumerator_names<Enum>.begin(), enumerator_names<Enum>.end()};
}

}  // namespace evbal
