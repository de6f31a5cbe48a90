#include "coordinator/serving/run_coordinator.hpp"

#include "agents/hosting/process.hpp"
#include "agents/hosting/roles.hpp"
#include "agents/protocol/message_check.hpp"
#include "agents/world/draws.hpp"
#include "agents/world/world.hpp"
#include "common/error.hpp"
#include "common/heap.hpp"
#include "coordinator/planning/receding_horizon_planner.hpp"
#include "faults/schedule/schedule.hpp"

#include <algorithm>

namespace evbal {
namespace {

void check_names(const std::vector<Controller>& own, const std::string& wanted) {
  std::vector<std::string> known = controller_names();
  for (const auto& controller : own) {
    if (std::ranges::find(known, controller.name) != known.end()) {
      throw bad_input("controller `" + controller.name + "`: the name is taken; give yours another");
    }
    known.push_back(controller.name);
  }
  if (std::ranges::find(known, wanted) == known.end()) {
    throw bad_input("this coordinator has no controller `" + wanted + "`" + did_you_mean(wanted, known));
  }
}

void plan(const std::vector<Controller>& own, const ProcessOptions& options, Participant& participant) {
  YamlMap scenario(YamlValue::load(options.scenario));
  const World world = read_world(scenario);
  const PlanningSettings settings = read_planning(scenario);
  check_names(own, settings.controller);
  RecedingHorizonPlanner planner(world.city, world.clock, world.day.date, settings,
                                 read_model(model_file(settings, world.city)), balancer_of(settings, own));
  if (foresees(settings.controller, own)) {
    const Eigen::VectorXi points = world.city.points();
    const Schedule schedule = read_resolved(scenario, {world.clock, {points.begin(), points.end()}});
    planner.foresee(demand_by_tick(world, [&](int tick) { return faults_at(schedule, world.clock, tick).effects; }));
  }
  const MessageBounds bounds = bounds_of(world);
  const auto make_plan = [&](const Tick& tick, const std::vector<Report>& reports) {
    refuse_garbage(tick, bounds, "the conductor");
    return planner.plan(tick, reports);
  };
  const Planner served = {.plan = make_plan,
                          .memory = [&] { return planner.memory(); },
                          .recall = [&](const Tick& tick, const auto& reports,
                                        const auto& memory) { planner.recall(tick, reports, memory); }};
  serve_coordinator(participant, options, served);
}

}  // namespace

int run_coordinator(int argc, char** argv, const std::vector<Controller>& own) {
  keep_heap_pages();
  return run_process(argc, argv, "Makes the plans of a run; started by evbal run",
                     [&](const ProcessOptions& options, Participant& participant) { plan(own, options, participant); });
}

}  // namespace evbal
