#include "agents/protocol/message_check.hpp"

#include "agents/protocol/reflection.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {
namespace {

const MessageBounds bounds{.regions = 5, .vehicles = 50, .battery_kwh = 40.0, .longest_trip = 30.0, .clock = {}};

/// One item in every list, at every depth.
struct OneOfEach {
  template <class Field>
  void operator()(std::string_view /*name*/, Field& field) const {
    if constexpr (std::is_class_v<Field> && !std::is_same_v<Field, std::string>) {
      for_each_field(field, *this);
    }
  }

  template <class Item>
  void operator()(std::string_view name, std::vector<Item>& items) const {
    items.resize(1);
    (*this)(name, items[0]);
  }
};

/// Calls `visit(name, value)` for each value of a type at any depth of a message.
template <class Value, class Visit>
struct Each {
  const Visit& visit;

  template <class Field>
  void operator()(std::string_view name, Field& field) const {
    if constexpr (std::is_same_v<Field, Value>) {
      visit(std::string(name), field);
    } else if constexpr (std::is_class_v<Field> && !std::is_same_v<Field, std::string>) {
      for_each_field(field, *this);
    }
  }

  template <class Item>
  void operator()(std::string_view name, std::vector<Item>& items) const {
    for (Item& item : items) {
      (*this)(name, item);
    }
  }
};

template <class Value, class Message, class Visit>
void each(Message& message, const Visit& visit) {
  Each<Value, Visit>{visit}("", message);
}

Plan plan() {
  Plan plan;
  OneOfEach{}("", plan);
  plan.moves[0] = {.from = 0, .to = 1, .count = 2};
  return plan;
}

Tick tick() {
  Tick tick;
  OneOfEach{}("", tick);
  tick.under_way[0].count = 1;
  return tick;
}

Departures departures() {
  Departures said;
  OneOfEach{}("", said);
  said.departures[0].arrival_minute = 5;
  said.departures[0].errand = Errand::charge;
  return said;
}

template <class Message>
Message one_of_each() {
  Message message;
  OneOfEach{}("", message);
  return message;
}

template <class Message>
void expect_finite_numbers(Message message) {
  ASSERT_EQ(validate(message, bounds), "");
  int numbers = 0;
  each<double>(message, [&](const std::string& name, double& number) {
    const double sound = number;
    for (const double spoilt : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity()}) {
      number = spoilt;
      EXPECT_EQ(validate(message, bounds), name + " " + std::to_string(spoilt));
    }
    number = sound;
    ++numbers;
  });
  EXPECT_GT(numbers, 0);
}

TEST(MessageCheck, RefusesNumbersThatAreNotFinite) {
  expect_finite_numbers(one_of_each<Faults>());
  expect_finite_numbers(tick());
  expect_finite_numbers(one_of_each<Report>());
  expect_finite_numbers(plan());
  expect_finite_numbers(departures());
}

TEST(MessageCheck, RefusesTextsThatAreNotUtf8) {
  Plan said = plan();
  each<std::string>(said, [&](const std::string& name, std::string& text) {
    for (const std::string& spoilt : {std::string("caf\xe9"), std::string("\xed\xa0\x80"), std::string("a\0b", 3)}) {
      text = spoilt;
      EXPECT_EQ(validate(said, bounds), name + " is no text in UTF-8");
    }
    text = "caf\xc3\xa9";
    EXPECT_EQ(validate(said, bounds), "");
  });
}

TEST(MessageCheck, RefusesAGapThatCannotBe) {
  Plan said = plan();
  Provenance& provenance = said.provenance;
  provenance.objective = 30.0;
  provenance.lower_bound = 24.0;
  provenance.gap = 6.0 / 30.0;
  EXPECT_EQ(validate(said, bounds), "");
  provenance.gap = -0.2;
  EXPECT_EQ(validate(said, bounds), "gap -0.200000 between 30 and its bound 24");
  provenance.gap = 7.0;
  EXPECT_EQ(validate(said, bounds), "gap 7 between 30 and its bound 24");
  provenance.max_violation = -1.0;
  provenance.gap = 0.0;
  EXPECT_EQ(validate(said, bounds), "max_violation -1");
}

}  // namespace
}  // namespace evbal
