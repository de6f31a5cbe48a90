#include "agents/bus/cdr.hpp"

#include "agents/bus/hello.hpp"
#include "agents/protocol/bytes.hpp"
#include "tests/support/random_message.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstring>

namespace evbal {
namespace {

template <class Message>
std::string cdr(const Message& message) {
  const Sample<Message> sample{"a run", message};
  std::string bytes(cdr_size(sample), '?');
  write_cdr(sample, bytes.data());
  return bytes;
}

/// Of a message all is read back. Bytes that are too few are known for it; of others with any bytes changed, either
/// that or they can be read.
template <class Message>
void write_and_tear() {
  const auto message = test::any_message<Message>();
  std::string bytes = cdr(message);
  const Sample<Message> read = read_cdr<Message>(bytes);
  RC_ASSERT(read.wrong == "");
  RC_ASSERT(read.run == "a run");
  RC_ASSERT(to_bytes(read.message) == to_bytes(message));
  const std::string part = bytes.substr(0, *rc::gen::inRange<std::size_t>(0, bytes.size()));
  RC_ASSERT(read_cdr<Message>(part).wrong != "");
  for (int changes = *rc::gen::inRange(1, 5); changes > 0; --changes) {
    bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::element<char>(0, 1, 2, 3, 127, -1, -128);
  }
  read_cdr<Message>(bytes);
}

RC_GTEST_PROP(Cdr, GivesHelloBack, ()) {
  write_and_tear<Hello>();
}

RC_GTEST_PROP(Cdr, GivesFaultsBack, ()) {
  write_and_tear<Faults>();
}

RC_GTEST_PROP(Cdr, GivesTickBack, ()) {
  write_and_tear<Tick>();
}

RC_GTEST_PROP(Cdr, GivesReportsBack, ()) {
  write_and_tear<std::vector<Report>>();
}

RC_GTEST_PROP(Cdr, GivesPlanBack, ()) {
  write_and_tear<Plan>();
}

RC_GTEST_PROP(Cdr, GivesDeparturesBack, ()) {
  write_and_tear<std::vector<Departures>>();
}

TEST(Cdr, KeepsOfListsWhatConcernsTheReadersRegions) {
  Tick tick;
  tick.due = {1, 2, 3, 4};
  for (const int region : {no_region, 1, 2, 3, 4}) {
    tick.arrivals.push_back({.region = region, .minute = 0, .errand = Errand::passenger, .vehicle = {}});
    tick.under_way.push_back({.region = region, .minute = 9, .errand = Errand::charge, .count = 1});
    tick.effects.push_back({.fault = 0, .region = region});
  }
  const Tick told = read_cdr<Tick>(cdr(tick), {2, 3}).message;
  EXPECT_EQ(told.due.size(), 4U);
  ASSERT_EQ(told.arrivals.size(), 2U);
  EXPECT_EQ(told.arrivals[0].region, 2);
  EXPECT_EQ(told.arrivals[1].region, 3);
  EXPECT_EQ(told.under_way.size(), 2U);
  EXPECT_EQ(told.effects.size(), 2U);
  Plan plan;
  plan.moves = {{.from = 1, .to = 2, .count = 1}, {.from = 2, .to = 1, .count = 1}};
  EXPECT_EQ(read_cdr<Plan>(cdr(plan), {1, 1}).message.moves.size(), 1U);
  EXPECT_EQ(read_cdr<Plan>(cdr(plan)).message.moves.size(), 2U);
}

/// A plan of three moves from region 9 whose bytes are `changed`, as a reader finds it.
template <class Change>
std::string what_is_wrong(Change change) {
  const Move move{.from = 9, .to = 1, .count = 2, .errand = Errand::charge};
  std::string bytes = cdr(Plan{.tick = 5, .moves = {move, move, move}, .provenance = {}, .origin = {}});
  change(bytes);
  return read_cdr<Plan>(bytes).wrong;
}

constexpr std::size_t length_of_run = 4;
constexpr std::size_t first_of_run = length_of_run + 4;
constexpr std::size_t length_of_moves = 4 + 4 + 8 + 4;  // encapsulation, text with its length and padding, tick
constexpr std::size_t errand_of_first_move = length_of_moves + 4 + 3 * 4;

TEST(Cdr, SaysWhyBytesAreNoMessage) {
  EXPECT_EQ(what_is_wrong([](std::string& /*bytes*/) {}), "");
  EXPECT_EQ(what_is_wrong([](std::string& bytes) { bytes[1] = 0; }), "it does not begin as little-endian CDR does");
  EXPECT_EQ(what_is_wrong([](std::string& bytes) { bytes.resize(3); }), "it does not begin as little-endian CDR does");
  EXPECT_EQ(what_is_wrong([](std::string& bytes) { bytes.resize(22); }), "bytes are missing");
  EXPECT_EQ(what_is_wrong([](std::string& bytes) { bytes[errand_of_first_move] = 3; }),
            "an enumerator is 3, the last one 2");
  EXPECT_EQ(what_is_wrong([](std::string& bytes) { bytes[first_of_run] = '\xe9'; }), "a text is not UTF-8");
  EXPECT_EQ(what_is_wrong([](std::string& bytes) { bytes[first_of_run] = '\0'; }), "a text is not UTF-8");
}

TEST(Cdr, BelievesNoLengthWithoutItsItems) {
  EXPECT_TRUE(what_is_wrong([](std::string& bytes) {
                ASSERT_EQ(bytes[length_of_moves], 3);
                std::memset(bytes.data() + length_of_moves, 0x7f, 4);
              }).starts_with("a length is 2139062143, the bytes left are "));
  EXPECT_TRUE(what_is_wrong([](std::string& bytes) {
                ASSERT_EQ(bytes[length_of_run], 6);
                std::memset(bytes.data() + length_of_run, -1, 4);
              }).starts_with("a length is 4294967295, the bytes left are "));
}

TEST(Cdr, RefusesBoolsThatAreNeither) {
  std::string bytes = cdr(Tick{});
  constexpr std::size_t plan_due = 4 + 4 + 8 + 4;
  ASSERT_EQ(bytes[plan_due], 0);
  bytes[plan_due] = 2;
  EXPECT_EQ(read_cdr<Tick>(bytes).wrong, "a bool is 2");
}

}  // namespace
}  // namespace evbal
