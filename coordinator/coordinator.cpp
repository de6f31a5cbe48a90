// evbal-coordinator: makes the plans of a run.

#include "coordinator/planning/coordinator.hpp"

#include "agents/bus/process.hpp"
#include "agents/bus/roles.hpp"
#include "agents/region/draws.hpp"
#include "agents/region/world.hpp"
#include "faults/schedule/schedule.hpp"

namespace {

using namespace evbal;

void plan(const ProcessOptions& options, Participant& participant) {
  YamlMap scenario(YamlValue::load(options.scenario));
  const World world = read_world(scenario);
  const PlanningSettings settings = read_planning(scenario);
  Coordinator coordinator(world.city, world.clock, world.day.date, settings,
                          read_model(model_file(settings, world.city)));
  if (settings.foresees()) {
    const Eigen::VectorXi points = world.city.points();
    const Schedule schedule = read_resolved(scenario, {world.clock, {points.begin(), points.end()}});
    coordinator.foresee(
        demand_by_tick(world, [&](int tick) { return faults_at(schedule, world.clock, tick).effects; }));
  }
  const Planner planner = {
      .plan = [&](const Tick& tick, const auto& reports) { return coordinator.plan(tick, reports); },
      .memory = [&] { return coordinator.memory(); },
      .recall = [&](const Tick& tick, const auto& reports,
                    const auto& memory) { coordinator.recall(tick, reports, memory); }};
  serve_coordinator(participant, options, planner);
}

}  // namespace

int main(int argc, char** argv) {
  return evbal::run_process(argc, argv, "Makes the plans of a run; started by evbal run", plan);
}
