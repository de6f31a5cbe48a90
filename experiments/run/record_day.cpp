#include "experiments/run/record_day.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/interrupt.hpp"
#include "coordinator/planning/coordinator_command.hpp"
#include "experiments/conductor/dds_players.hpp"
#include "experiments/conductor/empty_folder.hpp"
#include "experiments/conductor/inproc_players.hpp"
#include "experiments/conductor/run_day.hpp"
#include "experiments/record/summary.hpp"
#include "experiments/run/cross_check.hpp"
#include "experiments/run/external_plans.hpp"
#include "experiments/run/scenario_planner.hpp"
#include "experiments/scenario/input_digests.hpp"

#include <memory>
#include <utility>

namespace evbal {
namespace {

/// The coordinator's command on the bus, with its program as it will be started. Throws Error{bad_input} if there is no
/// such program.
Command startable(const Command& coordinator) {
  Command command = on_the_bus(coordinator);
  if (!command.empty()) {
    command.front() = file_of(command).string();
  }
  return command;
}

InprocPlayers::Planner plans_of(const Scenario& scenario, const std::filesystem::path& folder) {
  if (!scenario.planning.coordinator.empty()) {
    return external_plans(scenario, folder);
  }
  return [planner = planner_of(scenario)](const Tick& tick, const std::vector<Report>& reports) {
    return planner->plan(tick, reports);
  };
}

/// `schedule` must outlive the players, who follow it as it becomes.
std::unique_ptr<Players> players_of(const Scenario& scenario, const Schedule& schedule,
                                    const std::filesystem::path& folder, const std::string& transport) {
  if (transport == "dds") {
    return std::make_unique<DdsPlayers>(DdsRun{.folder = folder,
                                               .regions = scenario.world.city.size(),
                                               .regions_per_process = scenario.regions_per_process,
                                               .world = &scenario.world,
                                               .coordinator = startable(scenario.planning.coordinator),
                                               .network = scenario.network,
                                               .seed = scenario.world.seed,
                                               .profiles = scenario.dds_profiles,
                                               .hosts = scenario.hosts,
                                               .security = scenario.security});
  }
  return std::make_unique<InprocPlayers>(
      scenario.world, plans_of(scenario, folder),
      [&scenario, &schedule](int tick) { return faults_at(schedule, scenario.world.clock, tick); },
      scenario.regions_per_process);
}

MetricsFrame frame_of(const Scenario& scenario) {
  const Eigen::VectorXi points = scenario.world.city.points();
  return {.clock = scenario.world.clock,
          .points = {points.begin(), points.end()},
          .beta = scenario.planning.balancing.beta};
}

RunHeader header_of(const Scenario& scenario, const std::string& resolved, const Stage& stage) {
  const World& world = scenario.world;
  RunHeader header;
  header.scenario = scenario.name;
  header.resolved = resolved;
  header.inputs = input_digests(scenario);
  header.date = world.day.date;
  header.seed = world.seed;
  header.controller = scenario.planning.controller;
  header.engine = scenario.planning.engine.name;
  header.transport = scenario.transport;
  header.network = scenario.network;
  header.dds_profiles = scenario.dds_profiles;
  header.security = scenario.security.has_value() && stage.transport == "dds";
  header.frame = frame_of(scenario);
  for (const auto& region : world.city.regions) {
    header.region_names.push_back(region.name);
  }
  for (const auto& fault : scenario.schedule.faults) {
    header.faults.push_back(requested(fault));
  }
  return header;
}

RunResult play_and_record(const Scenario& scenario, const std::string& resolved, const std::filesystem::path& folder,
                          const Stage& stage) {
  RunRecord record(folder, header_of(scenario, resolved, stage));
  Schedule schedule = scenario.schedule;
  const auto players = players_of(scenario, schedule, folder, stage.transport);
  const auto observe = [&](const TickRecord& tick) {
    players->legs().time("record", [&] { record.add(tick); });
    if (stage.on_tick) {
      stage.on_tick(tick);
    }
    check_interrupt();
  };
  std::optional<DayDoor> door;
  if (stage.door) {
    door.emplace(DayDoor::Day{scenario, schedule, *players, record}, *stage.door);
  }
  try {
    run_day(scenario.world, *players, observe, [&](int tick) {
      if (door) {
        door->before_tick(tick);
      }
    });
  } catch (const Error& error) {
    record.break_off(error.what());
    throw;
  }
  return record.finish(players->end(), cross_check(scenario, record.ticks()));
}

DayResult play_without_record(const Scenario& scenario, Players& players) {
  std::vector<TickRecord> ticks;
  run_day(scenario.world, players, [&](const TickRecord& tick) { ticks.push_back(tick); });
  return result_of(scenario, ticks);
}

}  // namespace

DayResult result_of(const Scenario& scenario, const std::vector<TickRecord>& ticks) {
  return {
      .metrics = measure(frame_of(scenario), ticks), .digest = digest_of(ticks), .fallbacks = count_fallbacks(ticks)};
}

std::string own_transport(const Scenario& scenario) {
  return scenario.planning.coordinator.empty() ? "inproc" : scenario.transport;
}

Scenario with_controller(Scenario scenario, const std::string& controller) {
  scenario.controllers = {controller};
  scenario.planning.controller = controller;
  return scenario;
}

Scenario without_faults(Scenario scenario) {
  scenario.schedule.faults.clear();
  scenario.expect.clear();
  scenario.cross_check = CrossCheck::off;
  scenario.transport = own_transport(scenario);
  scenario.network.reset();
  scenario.hosts.clear();
  scenario.dds_profiles.clear();
  scenario.security.reset();
  return scenario;
}

void check_planning(const Scenario& scenario) {
  const Command& coordinator = scenario.planning.coordinator;
  if (coordinator.empty()) {
    planner_of(scenario);
  } else {
    file_of(scenario.transport == "dds" ? startable(coordinator) : own_words(coordinator));
  }
}

RunResult record_day(const Scenario& scenario, const std::string& resolved, const std::filesystem::path& folder,
                     const Stage& stage) {
  try {
    return play_and_record(scenario, resolved, folder, stage);
  } catch (const Error& error) {
    const Command& coordinator = scenario.planning.coordinator;
    if (coordinator.empty() || stage.transport == "inproc") {
      throw;
    }
    const bool bridged = own_words(coordinator) != coordinator || is_library(coordinator);
    const std::string hint = bridged ? "" : "; one that speaks in lines needs `evbal-bridge` before it on the bus";
    throw Error(error.status(),
                std::string(error.what()) + " (the coordinator is `" + shown(coordinator) + "`" + hint + ")");
  }
}

DayResult play_day(const Scenario& scenario) {
  return play_without_record(scenario, *players_of(scenario, scenario.schedule, {}, "inproc"));
}

DayResult play_day(const Scenario& scenario, const std::filesystem::path& folder) {
  const EmptyFolder own(folder);
  write_file(folder / "scenario.resolved.yaml", resolved_yaml(scenario, scenario.planning.controller));
  return play_without_record(scenario, *players_of(scenario, scenario.schedule, folder, scenario.transport));
}

}  // namespace evbal
