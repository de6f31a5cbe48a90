#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

/// The members of a plain struct, which C++20 gives only to who knows how many they are.
namespace evbal::reflection {

struct Anything {
  template <class Type>
  operator Type() const;
};

template <class Message, std::size_t... i>
constexpr bool takes(std::index_sequence<i...> /*count*/) {
  return requires {
    Message{(static_cast<void>(i), Anything{})...};
  };
}

/// Members of a struct: the most values that it can be initialised with, at most `count`.
template <class Message, std::size_t count>
constexpr std::size_t count_members() {
  if constexpr (takes<Message>(std::make_index_sequence<count>{})) {
    return count;
  } else {
    return count_members<Message, count - 1>();
  }
}

/// References to all members of a struct.
template <class Message>
constexpr auto tie_members(Message& message) {
  constexpr std::size_t most = 24;
  constexpr std::size_t count = count_members<std::remove_const_t<Message>, most + 1>();
  static_assert(count <= most, "a struct has more members than there are lines below: add some");
  // A structured binding must name as many members as there are.
  // clang-format off
  if constexpr (count == 1) { auto& [a] = message; return std::tie(a); }
  if constexpr (count == 2) { auto& [a, b] = message; return std::tie(a, b); }
  if constexpr (count == 3) { auto& [a, b, c] = message; return std::tie(a, b, c); }
  if constexpr (count == 4) { auto& [a, b, c, d] = message; return std::tie(a, b, c, d); }
  if constexpr (count == 5) { auto& [a, b, c, d, e] = message; return std::tie(a, b, c, d, e); }
  if constexpr (count == 6) { auto& [a, b, c, d, e, f] = message; return std::tie(a, b, c, d, e, f); }
  if constexpr (count == 7) { auto& [a, b, c, d, e, f, g] = message; return std::tie(a, b, c, d, e, f, g); }
  if constexpr (count == 8) { auto& [a, b, c, d, e, f, g, h] = message; return std::tie(a, b, c, d, e, f, g, h); }
  if constexpr (count == 9) { auto& [a, b, c, d, e, f, g, h, i] = message; return std::tie(a, b, c, d, e, f, g, h, i); }
  if constexpr (count == 10) { auto& [a, b, c, d, e, f, g, h, i, j] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j); }
  if constexpr (count == 11) { auto& [a, b, c, d, e, f, g, h, i, j, k] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k); }
  if constexpr (count == 12) { auto& [a, b, c, d, e, f, g, h, i, j, k, l] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l); }
  if constexpr (count == 13) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m); }
  if constexpr (count == 14) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n); }
  if constexpr (count == 15) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o); }
  if constexpr (count == 16) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p); }
  if constexpr (count == 17) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q); }
  if constexpr (count == 18) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r); }
  if constexpr (count == 19) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s); }
  if constexpr (count == 20) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t); }
  if constexpr (count == 21) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u); }
  if constexpr (count == 22) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v); }
  if constexpr (count == 23) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w); }
  if constexpr (count == 24) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x] = message;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x); }
  // clang-format on
}

}  // namespace evbal::reflection
