#include "experiments/run/day_door.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/interrupt.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "faults/schedule/by_hand.hpp"

#include <algorithm>
#include <thread>
#include <utility>

namespace evbal {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::steady_clock::duration look = 50ms;  // between looks for requests while the day stands still

std::string schedule_text(const Schedule& schedule, const DayClock& clock) {
  YamlWriter yaml;
  write_schedule(yaml, schedule, clock);
  return yaml.finish();
}

}  // namespace

DayDoor::DayDoor(const Day& day, DoorOptions options)
    : day_(day), options_(std::move(options)), box_(day.record.folder()), due_(Clock::now()) {
  pace_.speed = options_.speed;
}

void DayDoor::before_tick(int tick) {
  pace_.tick = tick;
  const auto answer_all = [&] { box_.answer_all([&](const std::string& request) { return answer(request); }); };
  answer_all();
  tell();
  while (!may_go_on()) {
    check_interrupt();
    std::this_thread::sleep_for(pace_.paused ? look : std::min(look, due_ - Clock::now()));
    day_.players.stand_still();
    answer_all();
    tell();
  }
  steps_ = std::max(0, steps_ - 1);
  const auto now = Clock::now();
  const double seconds = pace_.speed ? 60.0 * day_.scenario.world.clock.tick / *pace_.speed : 0.0;
  due_ = std::max(now, due_) + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

bool DayDoor::may_go_on() const {
  return pace_.paused ? steps_ > 0 : !pace_.speed || Clock::now() >= due_;
}

void DayDoor::tell() {
  pace_.processes = day_.players.processes();
  if (pace_ != told_ && options_.on_pace) {
    options_.on_pace(pace_);
    told_ = pace_;
  }
}

std::string DayDoor::answer(const std::string& text) {
  const DayRequest request = read_day_request(text);
  switch (request.deed) {
    case DayDeed::fault:
      return add_fault(*request.fault);
    case DayDeed::schedule:
      return schedule_text(day_.schedule, day_.scenario.world.clock);
    case DayDeed::kill:
      day_.players.kill(request.process);
      return "done";
    case DayDeed::speed:
      pace_.speed = request.speed;
      break;
    case DayDeed::pause:
    case DayDeed::go_on:
    case DayDeed::tick:
      pace_.paused = request.deed != DayDeed::go_on;
      steps_ = request.deed == DayDeed::tick ? 1 : 0;
      break;
  }
  due_ = Clock::now();
  return "done";
}

std::string DayDoor::add_fault(const YamlValue& entry) {
  const std::string& controller = day_.scenario.planning.controller;
  if (day_.scenario.planning.coordinator.empty() && foresees(controller)) {
    throw entry.error("controller `" + controller + "` was told the day's faults before it began; choose another one");
  }
  const World& world = day_.scenario.world;
  Schedule amended = with_fault_by_hand(day_.schedule, entry, fault_context(day_.scenario), pace_.tick);
  Scenario scenario = day_.scenario;
  scenario.schedule = amended;
  const Fault& fault = amended.faults.back();
  day_.record.amend(resolved_yaml(scenario, scenario.planning.controller), requested(fault));
  write_file(day_.record.folder() / "faults.yaml", schedule_text(amended, world.clock));
  day_.schedule = std::move(amended);
  day_.players.amended(static_cast<int>(day_.schedule.faults.size()) - 1);
  if (options_.on_fault) {
    options_.on_fault(day_.schedule.faults.back());
  }
  return "fault `" + day_.schedule.faults.back().name + "` begins at " +
         time_of_day(world.clock, world.clock.minute_of(pace_.tick));
}

}  // namespace evbal
