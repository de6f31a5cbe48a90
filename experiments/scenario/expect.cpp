#include "experiments/scenario/expect.hpp"

#include "common/decimal.hpp"

#include <algorithm>
#include <iterator>

namespace evbal {
namespace {

Expect read_one(const YamlValue& item) {
  YamlMap map(item);
  Expect expect;
  expect.metric = expectable_metrics()[map.require("metric").one_of(expectable_metrics())];
  const auto at_most = map.find("at_most");
  const auto at_least = map.find("at_least");
  if (const auto under = map.find("under")) {
    under->one_of({"search"});
    expect.under_search = true;
  }
  map.finish();
  if (at_most.has_value() == at_least.has_value()) {
    throw item.error("expected either `at_most` or `at_least`, such as {metric: lost, at_most: 900}");
  }
  expect.at_most = at_most.has_value();
  expect.bound = at_most ? at_most->number() : at_least->number();
  return expect;
}

}  // namespace

std::string Expect::words() const {
  return (at_most ? "at most " : "at least ") + decimal(bound);
}

const std::vector<std::string>& expectable_metrics() {
  static const std::vector<std::string> names = {
      "served", "lost", "idle_km", "unfairness_demand", "unfairness_charging", "charger_wait_min", "unserved_ratio"};
  return names;
}

std::vector<Expect> of_runs(const std::vector<Expect>& all) {
  std::vector<Expect> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some), [](const Expect& e) { return !e.under_search; });
  return some;
}

std::vector<Expect> read_expect(const YamlValue& list) {
  std::vector<Expect> all;
  for (const auto& item : list.items()) {
    all.push_back(read_one(item));
  }
  return all;
}

void write_expect(YamlWriter& yaml, const Expect& expect) {
  yaml.begin_map(YamlWriter::Layout::one_line).key("metric").word(expect.metric);
  yaml.key(expect.at_most ? "at_most" : "at_least").number(expect.bound);
  if (expect.under_search) {
    yaml.key("under").word("search");
  }
  yaml.end_map();
}

}  // namespace evbal
