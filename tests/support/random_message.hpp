#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/protocol/reflection.hpp"

#include <rapidcheck.h>

#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace evbal::test {

/// Gives every field of a message, or of a list of messages, any value.
struct AnyValue {
  template <class Field>
  void operator()(std::string_view /*name*/, Field& field) const {
    if constexpr (std::is_enum_v<Field>) {
      field = static_cast<Field>(*rc::gen::inRange(std::size_t{0}, enumerators<Field>));
    } else if constexpr (std::is_same_v<Field, double>) {
      const double special[] = {-0.0, std::numeric_limits<double>::infinity(), 1e-310};
      field = *rc::gen::inRange(0, 4) == 0 ? special[*rc::gen::inRange(0, 3)] : *rc::gen::arbitrary<double>();
    } else if constexpr (std::is_arithmetic_v<Field>) {
      field = *rc::gen::arbitrary<Field>();
    } else if constexpr (std::is_same_v<Field, std::string>) {
      field = *rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127));
    } else {
      for_each_field(field, *this);
    }
  }

  template <class Item>
  void operator()(std::string_view name, std::vector<Item>& items) const {
    items.resize(static_cast<std::size_t>(*rc::gen::inRange(0, 4)));
    for (auto& item : items) {
      (*this)(name, item);
    }
  }
};

template <class Message>
Message any_message() {
  Message message;
  AnyValue{}("", message);
  return message;
}

}  // namespace evbal::test
