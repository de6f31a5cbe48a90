#include "tools/console/console.hpp"

#include "common/error.hpp"
#include "experiments/record/events.hpp"
#include "tools/console/console_page.hpp"
#include "tools/console/day_json.hpp"

#include <chrono>

namespace evbal {
namespace {

using namespace std::chrono_literals;

constexpr auto patience = 60s;  // a tick of the largest city takes some seconds

}  // namespace

Console::Console(int port)
    : server_(port, {.page = console_page(), .ask = [this](const std::string& request) { return ask(request); }},
              feed_) {}

Console::~Console() {
  feed_.close();
}

void Console::begin(const Scenario& scenario, const std::filesystem::path& folder) {
  {
    const std::lock_guard lock(mutex_);
    folder_ = folder;
  }
  fault_names_.clear();
  for (const Fault& fault : scenario.schedule.faults) {
    fault_names_.push_back(fault.name);
  }
  so_far_ = {};
  last_.reset();
  feed_.begin_day(day_json(scenario, folder));
}

void Console::add(const TickRecord& record) {
  so_far_ = with_tick(so_far_, record);
  feed_.tell("tick", tick_json(record, so_far_, events_of(record, last_ ? &*last_ : nullptr, fault_names_)));
  last_ = record;
}

void Console::add_fault(const Fault& fault) {
  feed_.tell("fault", fault_json(static_cast<int>(fault_names_.size()), fault));
  fault_names_.push_back(fault.name);
}

void Console::note_pace(const DayPace& pace) {
  feed_.tell_state(pace_json(pace));
}

void Console::add_twin(const std::vector<DayTally>& ticks) {
  for (const DayTally& tick : ticks) {
    feed_.tell("twin", tally_json(tick));
  }
}

std::string Console::ask(const std::string& request) const {
  const auto folder = [&] {
    const std::lock_guard lock(mutex_);
    return folder_;
  }();
  if (folder.empty()) {
    throw bad_input("the day has not begun yet");
  }
  return ask_run(folder, request, patience);
}

}  // namespace evbal
