#include "experiments/scenario/expect.hpp"

#include <array>
#include <charconv>

namespace evbal {
namespace {

Expect read_one(const YamlValue& item) {
  YamlMap map(item);
  Expect expect;
  expect.metric = expectable_metrics()[map.require("metric").one_of(expectable_metrics())];
  const auto at_most = map.find("at_most");
  const auto at_least = map.find("at_least");
  map.finish();
  if (at_most.has_value() == at_least.has_value()) {
    throw item.error("expected either `at_most` or `at_least`, such as {metric: lost, at_most: 900}");
  }
  expect.at_most = at_most.has_value();
  expect.bound = at_most ? at_most->number() : at_least->number();
  return expect;
}

std::string bound_of(const Expect& expect) {
  std::array<char, 32> bound{};
  const auto end = std::to_chars(bound.data(), bound.data() + bound.size(), expect.bound).ptr;
  return {bound.data(), end};
}

}  // namespace

std::string Expect::words() const {
  return (at_most ? "at most " : "at least ") + bound_of(*this);
}

const std::vector<std::string>& expectable_metrics() {
  static const std::vector<std::string> names = {
      "served", "lost", "idle_km", "unfairness_demand", "unfairness_charging", "charger_wait_min", "unserved_ratio"};
  return names;
}

std::vector<Expect> read_expect(const YamlValue& list) {
  std::vector<Expect> all;
  for (const auto& item : list.items()) {
    all.push_back(read_one(item));
  }
  return all;
}

std::string expect_yaml(const Expect& expect) {
  return "{metric: " + expect.metric + (expect.at_most ? ", at_most: " : ", at_least: ") + bound_of(expect) + "}";
}

}  // namespace evbal
