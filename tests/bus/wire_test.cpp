#include "agents/bus/wire.hpp"

#include "agents/bus/cdr_walk.hpp"
#include "agents/protocol/fields.hpp"
#include "common/error.hpp"
#include "tests/support/spoilt.hpp"

#include <evbalPubSubTypes.h>
#include <fastdds/rtps/common/SerializedPayload.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <limits>
#include <type_traits>

namespace evbal {
namespace {

/// Fills every field that fields.hpp knows.
struct Fill {
  template <class Field>
  void operator()(const char* /*name*/, Field& field) const {
    if constexpr (std::is_enum_v<Field>) {
      field = static_cast<Field>(*rc::gen::inRange(0, test::enumerators(field)));
    } else if constexpr (std::is_same_v<Field, double>) {
      const double special[] = {-0.0, std::numeric_limits<double>::infinity(), 1e-310};
      field = *rc::gen::inRange(0, 4) == 0 ? special[*rc::gen::inRange(0, 3)] : *rc::gen::arbitrary<double>();
    } else if constexpr (std::is_arithmetic_v<Field>) {
      field = *rc::gen::arbitrary<Field>();
    } else if constexpr (std::is_same_v<Field, std::string>) {
      field = *rc::gen::string<std::string>();
      std::erase(field, '\0');  // texts on the wire end at the first zero byte
    } else {
      fields(*this, field);
    }
  }

  template <class Item>
  void operator()(const char* name, std::vector<Item>& items) const {
    items.resize(static_cast<std::size_t>(*rc::gen::inRange(0, 4)));
    for (auto& item : items) {
      (*this)(name, item);
    }
  }
};

/// The bytes of every field, Origin too.
struct Bytes {
  std::string text;

  template <class Field>
  void operator()(const char* name, const Field& field) {
    if constexpr (std::is_arithmetic_v<Field> || std::is_enum_v<Field>) {
      text.append(name).append(reinterpret_cast<const char*>(&field), sizeof field);
    } else if constexpr (std::is_same_v<Field, std::string>) {
      text.append(name).append(field).push_back('\0');
    } else {
      fields(*this, field);
    }
  }

  template <class Item>
  void operator()(const char* name, const std::vector<Item>& items) {
    text.append(std::to_string(items.size()));
    for (const auto& item : items) {
      (*this)(name, item);
    }
  }
};

template <class Message>
std::string bytes(const Message& message) {
  Bytes all;
  all("", message);
  return all.text;
}

template <class Type, class Wire>
std::string cdr(const Wire& sent) {
  Type type;
  Wire copy = sent;
  eprosima::fastrtps::rtps::SerializedPayload_t payload(type.getSerializedSizeProvider(&copy)());
  RC_ASSERT(type.serialize(&copy, &payload));
  return {reinterpret_cast<const char*>(payload.data), payload.length};
}

template <class Type>
auto from_cdr(const std::string& bytes) {
  eprosima::fastrtps::rtps::SerializedPayload_t payload(static_cast<std::uint32_t>(bytes.size()));
  std::memcpy(payload.data, bytes.data(), bytes.size());
  payload.length = static_cast<std::uint32_t>(bytes.size());
  typename Type::type received;
  RC_ASSERT(Type().deserialize(&payload, &received));
  return received;
}

template <class Type, class Message>
void round_trip() {
  Message message;
  Fill{}("", message);
  const auto sent = to_wire("a run", message);
  RC_ASSERT(sent.run() == "a run");
  const auto received = from_cdr<Type>(cdr<Type>(sent));
  RC_ASSERT(received.run() == "a run");
  RC_ASSERT(bytes(from_wire(received)) == bytes(message));
}

RC_GTEST_PROP(Wire, GivesHelloBack, ()) {
  round_trip<wire::HelloPubSubType, Hello>();
}

RC_GTEST_PROP(Wire, GivesFaultsBack, ()) {
  round_trip<wire::FaultsPubSubType, Faults>();
}

RC_GTEST_PROP(Wire, GivesTickBack, ()) {
  round_trip<wire::TickPubSubType, Tick>();
}

RC_GTEST_PROP(Wire, GivesReportsBack, ()) {
  round_trip<wire::ReportsPubSubType, std::vector<Report>>();
}

RC_GTEST_PROP(Wire, GivesPlanBack, ()) {
  round_trip<wire::PlanPubSubType, Plan>();
}

RC_GTEST_PROP(Wire, GivesDeparturesBack, ()) {
  round_trip<wire::DeparturesPubSubType, std::vector<Departures>>();
}

/// Messages that miss bytes are known for it; of others with any bytes changed, either that or they can be read.
template <class Type, class Message>
void tear() {
  Message message;
  Fill{}("", message);
  std::string bytes = cdr<Type>(to_wire("a run", message));
  RC_ASSERT(is_whole<Message>(bytes));
  RC_ASSERT(!is_whole<Message>(bytes.substr(0, *rc::gen::inRange<std::size_t>(0, bytes.size()))));
  for (int changes = *rc::gen::inRange(1, 5); changes > 0; --changes) {
    bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::element<char>(0, 1, 2, 3, 127, -1, -128);
  }
  if (is_whole<Message>(bytes)) {
    const auto received = from_cdr<Type>(bytes);
    try {
      from_wire(received);
    } catch (const Error&) {
    }
  }
}

RC_GTEST_PROP(CdrWalk, KnowsWholeMessages, ()) {
  tear<wire::HelloPubSubType, Hello>();
  tear<wire::FaultsPubSubType, Faults>();
  tear<wire::TickPubSubType, Tick>();
  tear<wire::ReportsPubSubType, std::vector<Report>>();
  tear<wire::PlanPubSubType, Plan>();
  tear<wire::DeparturesPubSubType, std::vector<Departures>>();
}

TEST(CdrWalk, BelievesNoLengthWithoutItsItems) {
  Plan plan;
  plan.moves.resize(3);
  std::string bytes = cdr<wire::PlanPubSubType>(to_wire("a run", plan));
  const std::size_t length_of_moves = 4 + 4 + 8 + 4;  // encapsulation, text with its length, tick
  ASSERT_EQ(bytes[length_of_moves], 3);
  std::memset(bytes.data() + length_of_moves, 0x7f, 4);
  EXPECT_FALSE(is_whole<Plan>(bytes));
}

TEST(Wire, RefusesEnumeratorsThatDoNotExist) {
  auto plan = to_wire("a run", Plan{.tick = 0, .moves = {Move{}}, .provenance = {}, .origin = {}});
  plan.moves()[0].errand(static_cast<wire::Errand>(3));
  EXPECT_THROW(from_wire(plan), Error);
}

}  // namespace
}  // namespace evbal
