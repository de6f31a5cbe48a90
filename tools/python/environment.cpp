#include "tools/python/environment.hpp"

#include "agents/world/city.hpp"
#include "common/error.hpp"
#include "common/suggestion.hpp"
#include "experiments/metrics/columns.hpp"

#include <cmath>
#include <utility>

namespace evbal {

std::vector<std::pair<std::string, double>> named_flows(const Flows& flows, double beta) {
  std::vector<std::pair<std::string, double>> values;
  columns([&](const char* name, auto value) { values.emplace_back(name, static_cast<double>(value)); }, flows);
  values.emplace_back("idle_km", flows.rebalance_km + beta * flows.charge_km);
  return values;
}

std::vector<std::string> reward_metrics() {
  std::vector<std::string> names;
  for (const auto& [name, value] : named_flows({}, 1.0)) {
    names.push_back(name);
  }
  return names;
}

Environment::Environment(const Scenario& scenario, const std::map<std::string, double>& reward)
    : scenario_(scenario), weights_(reward) {
  for (const auto& [name, weight] : reward) {
    if (const auto wrong = validate_word(name, reward_metrics()); !wrong.empty()) {
      throw bad_input("reward: " + wrong);
    }
    if (!std::isfinite(weight)) {
      throw bad_input("reward: " + name + ": a finite number is expected");
    }
  }
}

void Environment::begin(std::uint64_t seed, const std::string& date) {
  if (!date.empty() && date != scenario_.world.day.date) {
    if (const auto wrong = validate_word(date, scenario_.world.city.days); !wrong.empty()) {
      throw bad_input("day: " + wrong);
    }
    scenario_.world.day = read_demand(scenario_.world.city, date);
  }
  scenario_.world.seed = seed;
  day_.reset();
  day_ = std::make_shared<SteppedDay>(scenario_);
  broken_ = false;
  taken_ = 0;
  take_changes();
}

const std::shared_ptr<SteppedDay>& Environment::day() const {
  if (!day_) {
    throw run_failed("no day was begun; call reset() first");
  }
  return day_;
}

void Environment::step(Plan plan) {
  if (day()->over() || broken_) {
    throw run_failed(broken_ ? "the day broke off; begin another one by reset()"
                             : "the day is over; begin another one by reset()");
  }
  broken_ = true;
  day_->step(std::move(plan));
  broken_ = false;
  take_changes();
}

void Environment::take_changes() {
  changes_.assign(scenario_.world.city.regions.size(), {});
  seen_.clear();
  const auto& ticks = day_->ticks();
  for (; taken_ < ticks.size(); ++taken_) {
    for (const auto& said : ticks[taken_].exchange.departures) {
      changes_[static_cast<std::size_t>(said.region)].flows += flows_of(said);
    }
    note_seen(ticks[taken_]);
  }
  if (!ticks.empty()) {
    for (const auto& said : ticks.back().exchange.departures) {
      changes_[static_cast<std::size_t>(said.region)].stocks = stocks_of(said);
    }
  }
  Flows all;
  for (const auto& change : changes_) {
    all += change.flows;
  }
  reward_ = 0.0;
  for (const auto& [name, value] : named_flows(all, scenario_.planning.balancing.beta)) {
    const auto weight = weights_.find(name);
    reward_ += weight == weights_.end() ? 0.0 : weight->second * value;
  }
}

void Environment::note_seen(const TickRecord& record) {
  const auto note = [&](int region, const Observed& observed) {
    seen_.push_back(
        {scenario_.schedule.faults[static_cast<std::size_t>(observed.fault)].name, region, observed.amount});
  };
  for (const auto& said : record.exchange.departures) {
    for (const auto& observed : said.observed) {
      note(said.region, observed);
    }
  }
  for (const auto& seen : record.seen) {
    note(seen.region, seen.observed);
  }
}

}  // namespace evbal
