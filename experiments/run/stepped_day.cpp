#include "experiments/run/stepped_day.hpp"

#include "common/contract.hpp"
#include "experiments/run/record_day.hpp"

#include <utility>

namespace evbal {

SteppedDay::SteppedDay(const Scenario& scenario)
    : scenario_(scenario),
      players_(
          scenario_.world, {}, [this](int tick) { return faults_at(scenario_.schedule, scenario_.world.clock, tick); },
          scenario_.regions_per_process),
      conductor_(scenario_.world, players_, [this](const TickRecord& record) { ticks_.push_back(record); }) {
  go_on();
}

void SteppedDay::step(Plan plan) {
  EVBAL_EXPECT(!over_, "a day that is not over");
  planned_.push_back({tick_, std::move(reports_), plan.moves});
  said_.plan = std::move(plan);
  players_.live(tick_, said_);
  conductor_.end_tick(std::move(said_));
  go_on();
}

void SteppedDay::go_on() {
  while (!conductor_.over()) {
    tick_ = conductor_.begin_tick();
    said_ = players_.report(tick_);
    if (tick_.plan_due) {
      reports_ = heard_in_time(tick_, said_.reports);
      return;
    }
    players_.live(tick_, said_);
    conductor_.end_tick(std::move(said_));
  }
  conductor_.end_day();
  reports_.clear();
  over_ = true;
}

DayResult SteppedDay::result() const {
  EVBAL_EXPECT(over_, "a day that is over");
  return result_of(scenario_, ticks_);
}

}  // namespace evbal
