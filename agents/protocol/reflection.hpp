#pragma once

#include "agents/protocol/tie_members.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

/// The fields of a plain struct and the enumerators of an enum with their names, as the compiler knows them: what is
/// declared need not be listed again. A struct has no bases, no arrays, 1 to 24 members and, for clang, does not stand
/// in a namespace without a name.
namespace evbal {

namespace reflection {

// A struct that is nowhere: its members have addresses, which the compiler prints with their names.
#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wundefined-var-template"
#endif
template <class Message>
extern const Message nowhere;

template <class Field>
struct Address {
  const Field* of;
};

template <class Message, std::size_t i>
constexpr auto address_of_member() {
  const auto& member = std::get<i>(tie_members(nowhere<Message>));
  return Address<std::remove_cvref_t<decltype(member)>>{&member};
}
#ifdef __clang__
#pragma clang diagnostic pop
#endif

constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// The last word of what the compiler prints of a constant: "... [with auto value = (& nowhere<M>.M::tick)]" or
/// "... [value = evbal::Errand::charge]", and of what is no enumerator "... [value = (evbal::Errand)3]".
template <auto value>
constexpr auto printed_name() {
  const std::string_view text = __PRETTY_FUNCTION__;
  std::size_t end = text.size();
  while (!is_letter(text[end - 1])) {
    --end;
  }
  std::size_t begin = end;
  while (is_letter(text[begin - 1])) {
    --begin;
  }
  return text.substr(begin, end - begin);
}

template <class Message, std::size_t i>
constexpr std::string_view member_name = printed_name<address_of_member<Message, i>()>();

template <class Enum, std::size_t value>
constexpr std::string_view value_name = printed_name<static_cast<Enum>(value)>();

template <class Enum, std::size_t value = 0>
constexpr std::size_t count_enumerators() {
  if constexpr (value_name<Enum, value>.front() >= '0' && value_name<Enum, value>.front() <= '9') {
    return value;
  } else {
    return count_enumerators<Enum, value + 1>();
  }
}

}  // namespace reflection

/// Calls `visit(name, field)` for each field of a struct, const or not, in the order of their declaration; the name is
/// a std::string_view.
template <class Message, class Visit>
constexpr void for_each_field(Message& message, Visit&& visit) {
  using Plain = std::remove_const_t<Message>;
  const auto members = reflection::tie_members(message);
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (visit(reflection::member_name<Plain, i>, std::get<i>(members)), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(members)>>{});
}

/// How many enumerators an enum has; they count from 0 without a gap.
template <class Enum>
inline constexpr std::size_t enumerators = reflection::count_enumerators<Enum>();

/// Names of an enum's enumerators, in their order.
template <class Enum>
inline constexpr auto enumerator_names = []<std::size_t... i>(std::index_sequence<i...>) {
  return std::array<std::string_view, sizeof...(i)>{reflection::value_name<Enum, i>...};
}
(std::make_index_sequence<enumerators<Enum>>{});

namespace reflection {

enum class Proof { first, second };

struct Proven {
  int number;
  Proof word;
};

static_assert(member_name<Proven, 1> == "word" && enumerator_names<Proof>[1] == "second" && enumerators<Proof> == 2,
              "this compiler prints names in another way");

}  // namespace reflection
}  // namespace evbal
