#include "experiments/progress/day_state.hpp"

#include <set>
#include <utility>

namespace evbal {

DayWatch::DayWatch(DayClock clock, std::vector<std::string> fault_names)
    : clock_(clock), fault_names_(std::move(fault_names)) {}

void DayWatch::add(const TickRecord& record) {
  state_.ticks = record.tick.tick + 1;
  demand_.emplace_back(state_.vacant.size());
  if (static_cast<int>(demand_.size()) > clock_.step / clock_.tick) {
    demand_.pop_front();
  }
  for (const Departures& said : record.exchange.departures) {
    count(said);
  }
  sum_demand();
  name_faults(record.faults.effects);
  if (record.exchange.plan) {
    state_.planned_at = clock_.minute_of(record.tick.tick);
    state_.provenance = record.exchange.plan->provenance;
  }
}

void DayWatch::count(const Departures& said) {
  for (const Fate& fate : said.fates) {
    ++(fate.served ? state_.served : state_.lost);
  }
  const auto region = static_cast<std::size_t>(said.region);
  for (auto* numbers : {&state_.vacant, &state_.queue, &state_.waiting, &demand_.back()}) {
    numbers->resize(std::max(numbers->size(), region + 1));
  }
  state_.vacant[region] = said.vacant;
  state_.queue[region] = said.low_battery;
  state_.waiting[region] = said.waiting;
  demand_.back()[region] += said.demand;
}

void DayWatch::sum_demand() {
  state_.demand.assign(state_.vacant.size(), 0);
  for (const auto& tick : demand_) {
    for (std::size_t region = 0; region < tick.size(); ++region) {
      state_.demand[region] += tick[region];
    }
  }
}

void DayWatch::name_faults(const std::vector<Effect>& effects) {
  std::set<int> active;
  for (const Effect& effect : effects) {
    active.insert(effect.fault);
  }
  state_.faults.clear();
  for (const int fault : active) {
    state_.faults.push_back(fault_names_.at(static_cast<std::size_t>(fault)));
  }
}

}  // namespace evbal
