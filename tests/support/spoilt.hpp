#pragma once

#include "agents/protocol/reflection.hpp"

#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// Messages with one field of garbage.
namespace evbal::test {

/// Any value, mostly an extreme one or a neighbour. Enumerators exist: others do not get through the wire.
template <class Field>
void spoil(Field& field) {
  if constexpr (std::is_same_v<Field, bool>) {
    field = !field;
  } else if constexpr (std::is_enum_v<Field>) {
    field = static_cast<Field>(*rc::gen::inRange(std::size_t{0}, enumerators<Field>));
  } else if constexpr (std::is_floating_point_v<Field>) {
    using Limits = std::numeric_limits<double>;
    field = *rc::gen::element(Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(),
                              Limits::denorm_min(), -1.0, 0.0, field * 1e6 + 1.0, -field);
  } else if constexpr (std::is_integral_v<Field>) {
    using Limits = std::numeric_limits<Field>;
    const auto small = static_cast<Field>(*rc::gen::inRange(-3, 70));
    field = *rc::gen::element<Field>(Limits::min(), Limits::max(), -1, 0, small, field ^ 1, field ^ (1 << 20));
  } else {
    field = *rc::gen::string<std::string>();
  }
}

/// Visits all fields of a message, and a list also as a whole; spoils the one at a place.
class Spoiler {
 public:
  explicit Spoiler(int place = -1) : place_(place) {}

  template <class Field>
  void operator()(std::string_view name, Field& field) {
    if constexpr (std::is_class_v<Field> && !std::is_same_v<Field, std::string>) {
      for_each_field(field, *this);
    } else if (at_++ == place_) {
      name_ = name;
      spoil(field);
    }
  }

  template <class Item>
  void operator()(std::string_view name, std::vector<Item>& items) {
    if (at_++ == place_) {
      name_ = name;
      if (!items.empty() && *rc::gen::arbitrary<bool>()) {
        items.pop_back();
      } else {
        items.push_back(items.empty() ? Item{} : items.front());
      }
    }
    for (auto& item : items) {
      (*this)(name, item);
    }
  }

  int places() const { return at_; }
  const std::string& name() const { return name_; }

 private:
  int place_;
  int at_ = 0;
  std::string name_;
};

/// Spoils one field of the message, or of the list of messages, and gives its name.
template <class Message>
std::string spoil_one(Message& message) {
  Spoiler counting;
  counting("", message);
  Spoiler spoiler(*rc::gen::inRange(0, counting.places()));
  spoiler("", message);
  return spoiler.name();
}

}  // namespace evbal::test
