#include "experiments/run/scenario_planner.hpp"

#include "agents/world/draws.hpp"

namespace evbal {

std::shared_ptr<RecedingHorizonPlanner> planner_of(const Scenario& scenario, const Balancer& balancer) {
  const World& world = scenario.world;
  auto planner = std::make_shared<RecedingHorizonPlanner>(world.city, world.clock, world.day.date, scenario.planning,
                                                          read_model(model_file(scenario.planning, world.city)),
                                                          balancer ? balancer : balancer_of(scenario.planning));
  if (foresees(scenario.planning.controller)) {
    planner->foresee(
        demand_by_tick(world, [&](int tick) { return faults_at(scenario.schedule, world.clock, tick).effects; }));
  }
  return planner;
}

}  // namespace evbal
