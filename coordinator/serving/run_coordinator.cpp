#include "coordinator/serving/run_coordinator.hpp"

#include "agents/hosting/process.hpp"
#include "agents/hosting/roles.hpp"
#include "agents/protocol/message_check.hpp"
#include "agents/world/draws.hpp"
#include "agents/world/world.hpp"
#include "common/error.hpp"
#include "common/heap.hpp"
#include "common/pin.hpp"
#include "coordinator/bridge/json_lines.hpp"
#include "coordinator/planning/receding_horizon_planner.hpp"
#include "faults/schedule/schedule.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <memory>

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

/// What plans the day of a resolved scenario.
std::shared_ptr<RecedingHorizonPlanner> planner_of(YamlMap& scenario, const World& world,
                                                   const std::vector<Controller>& own) {
  const PlanningSettings settings = read_planning(scenario);
  check_names(own, settings.controller);
  const auto planner = std::make_shared<RecedingHorizonPlanner>(world.city, world.clock, world.day.date, settings,
                                                                read_model(model_file(settings, world.city)),
                                                                balancer_of(settings, own));
  if (foresees(settings.controller, own)) {
    const Eigen::VectorXi points = world.city.points();
    const Schedule schedule = read_resolved(scenario, {world.clock, {points.begin(), points.end()}});
    planner->foresee(demand_by_tick(world, [&](int tick) { return faults_at(schedule, world.clock, tick).effects; }));
  }
  return planner;
}

/// On the bus.
void serve(const std::vector<Controller>& own, const ProcessOptions& options, Participant& participant) {
  YamlMap scenario(YamlValue::load(options.scenario));
  const World world = read_world(scenario);
  const auto planner = planner_of(scenario, world, own);
  const MessageBounds bounds = bounds_of(world);
  const auto make_plan = [&](const Tick& tick, const std::vector<Report>& reports) {
    refuse_garbage(tick, bounds, "the conductor");
    return planner->plan(tick, reports);
  };
  const Planner served = {.plan = make_plan,
                          .memory = [&] { return planner->memory(); },
                          .recall = [&](const Tick& tick, const auto& reports,
                                        const auto& memory) { planner->recall(tick, reports, memory); }};
  serve_coordinator(participant, options, served);
}

/// Without a bus: by lines on standard input and output, until the input ends.
void answer_lines(const std::vector<Controller>& own) {
  std::string line;
  std::getline(std::cin, line);
  YamlMap scenario(YamlValue::parse(read_opening(line), "the resolved scenario"));
  const World world = read_world(scenario);
  const auto planner = planner_of(scenario, world, own);
  while (std::getline(std::cin, line)) {
    const PlanRequest question = read_question(line);
    std::cout << answer_line(planner->plan(question.tick, question.reports)) << '\n' << std::flush;
  }
}

int speak_lines(const std::vector<Controller>& own) {
  try {
    answer_lines(own);
    return static_cast<int>(ExitStatus::ok);
  } catch (const Error& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(error.status());
  }
}

}  // namespace

int run_coordinator(int argc, char** argv, const std::vector<Controller>& own) {
  keep_heap_pages();
  if (argc == 1 && isatty(STDIN_FILENO) == 0) {
    pin_arithmetic(argv);
    return speak_lines(own);
  }
  return run_process(
      argc, argv, "Makes the plans of a run; started by evbal run",
      [&](const ProcessOptions& options, Participant& participant) { serve(own, options, participant); });
}

}  // namespace evbal
